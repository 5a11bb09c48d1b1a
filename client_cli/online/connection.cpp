#include "client_cli/online/connection.hpp"

#include <poll.h>

#include <algorithm>
#include <array>
#include <utility>

#include "client_cli/command_error.hpp"
#include "common/wire/translate.hpp"

namespace breakshot::client {
namespace {

/// Whether coming back after this Goodbye makes sense.
bool may_return(lobby::GoodbyeReason reason) {
  return reason != lobby::GoodbyeReason::taken_over && reason != lobby::GoodbyeReason::bad_protocol;
}

void pause(Milliseconds length) {
  ::poll(nullptr, 0, static_cast<int>(length.count()));
}

}  // namespace

Connection::Connection(ServerAddress server, Guest guest, Notice notice, const Patience& patience)
    : server_(std::move(server)),
      guest_(std::move(guest)),
      notice_(std::move(notice)),
      patience_(patience) {
  if (guest_.store) token_ = guest_.store->load(server_, guest_.name);
  try {
    open();
  } catch (const Lost& lost) {
    throw CommandError(lost.what());
  }
}

lobby::Answer Connection::ask(const lobby::Request& request) {
  while (true) {
    try {
      if (!lost_.empty()) throw Lost(lost_);
      const lobby::Answer answer = ask_once(request);
      note(request, answer);
      return answer;
    } catch (const Lost& lost) {
      reopen(lost.what());
    }
  }
}

std::variant<record::Record, lobby::Refused> Connection::fetch(lobby::Fetch request) {
  std::optional<record::Header> header;
  std::vector<record::Entry> entries;
  const Piece keep = [&](const lobby::Answer& answer) {
    if (const auto* news = std::get_if<lobby::MatchNews>(&answer)) header = news->header;
    const auto* told = std::get_if<lobby::EntryNews>(&answer);
    if (told != nullptr && told->entry->seq == match::Seq(entries.size())) {
      entries.push_back(*told->entry);
    }
  };
  while (true) {
    try {
      if (!lost_.empty()) throw Lost(lost_);
      request.from = match::Seq(entries.size());
      const lobby::Answer answer = ask_once(request, keep);
      if (const auto* refused = std::get_if<lobby::Refused>(&answer)) return *refused;
      const auto* done = std::get_if<lobby::FetchDone>(&answer);
      if (done == nullptr || !header || done->next != match::Seq(entries.size())) {
        throw CommandError(text_of(server_) + " sent only parts of the record");
      }
      return record::Record{*header, std::move(entries)};
    } catch (const Lost& lost) {
      reopen(lost.what());
    }
  }
}

std::optional<News> Connection::next(Milliseconds patience, int other) {
  const auto deadline = Clock::now() + patience;
  while (news_.empty()) {
    try {
      if (!lost_.empty()) throw Lost(lost_);
      if (const auto told = take()) {
        hear(told->answer);
        continue;
      }
      const auto left = std::chrono::duration_cast<Milliseconds>(deadline - Clock::now());
      if (left <= Milliseconds::zero()) return std::nullopt;
      stay_in_touch();
      if (fill(std::min(left, patience_.quiet), other) == Woke::other) return std::nullopt;
    } catch (const Lost& lost) {
      reopen(lost.what());
    }
  }
  News news = std::move(news_.front());
  news_.pop_front();
  return news;
}

void Connection::serve() {
  if (!lost_.empty()) return;
  try {
    stay_in_touch();
    do {
      while (const auto told = take()) hear(told->answer);
    } while (fill(Milliseconds::zero(), -1) == Woke::stream);
  } catch (const Lost& lost) {
    lost_ = lost.what();
  }
}

// ---- One connection

void Connection::open() {
  lost_.clear();
  stream_.reset();
  stream_.emplace(server_, patience_.connect);
  frames_ = wire::FrameDecoder(wire::max_answer_frame);
  received_.clear();
  heard_ = spoke_ = Clock::now();
  hello();
}

void Connection::hello() {
  lobby::Answer answer = ask_once(lobby::Hello{lobby::protocol_version, guest_.name, token_});
  const auto* refused = std::get_if<lobby::Refused>(&answer);
  if (refused != nullptr && refused->code == lobby::RefusalCode::unknown_token && token_) {
    std::string what =
        "the server does not know " + guest_.name + " any more: a new guest of that name";
    if (guest_.store) {
      what += "; the old token is kept in " +
              guest_.store->set_aside(server_, guest_.name, *token_).string();
    }
    notice_(what);
    token_.reset();
    answer = ask_once(lobby::Hello{lobby::protocol_version, guest_.name, token_});
    refused = std::get_if<lobby::Refused>(&answer);
  }
  if (refused != nullptr) throw CommandError(text_of(server_) + ": " + refused->what);
  const auto* welcome = std::get_if<lobby::Welcome>(&answer);
  if (welcome == nullptr) throw CommandError(text_of(server_) + " does not answer a hello");
  welcome_ = *welcome;
  if (!welcome_.token) return;
  token_ = welcome_.token;
  if (guest_.store) guest_.store->save(server_, guest_.name, *token_);
}

void Connection::resume() {
  if (!following_) return;
  const Following& f = *following_;
  const lobby::Answer answer = f.seated ? ask_once(lobby::Join{f.match, std::nullopt, f.next})
                                        : ask_once(lobby::Watch{f.match, f.code, f.next});
  if (const auto* refused = std::get_if<lobby::Refused>(&answer)) {
    throw CommandError("cannot come back to the match: " + refused->what);
  }
  hear(answer);
}

void Connection::send(lobby::RequestId id, const lobby::Request& request) {
  stream_->send(wire::frame_of(lobby::Asked{id, request}), patience_.answer);
  spoke_ = Clock::now();
}

lobby::Answer Connection::ask_once(const lobby::Request& request, const Piece& piece) {
  const lobby::RequestId id{++last_id_};
  send(id, request);
  heard_ = spoke_;
  while (true) {
    const auto told = take();
    if (!told) {
      const auto silence = std::chrono::duration_cast<Milliseconds>(Clock::now() - heard_);
      if (silence >= patience_.answer) throw Lost("the server does not answer");
      fill(patience_.answer - silence, -1);
    } else if (told->id != id) {
      hear(told->answer);
    } else if (piece && (std::holds_alternative<lobby::MatchNews>(told->answer) ||
                         std::holds_alternative<lobby::EntryNews>(told->answer))) {
      piece(told->answer);
    } else {
      const auto* refused = std::get_if<lobby::Refused>(&told->answer);
      const bool later = refused != nullptr && refused->code == lobby::RefusalCode::unavailable;
      if (later) throw Lost(refused->what);
      return told->answer;
    }
  }
}

std::optional<lobby::Told> Connection::take() {
  std::span<const std::uint8_t> input(received_);
  const auto frame = frames_.take(input);
  received_.erase(received_.begin(), received_.end() - static_cast<std::ptrdiff_t>(input.size()));
  if (std::holds_alternative<wire::Unfinished>(frame)) return std::nullopt;
  const auto* body = std::get_if<wire::ByteVector>(&frame);
  if (body == nullptr) {
    throw CommandError(text_of(server_) + " does not speak Breakshot's protocol");
  }
  auto told = wire::read_told(*body);
  if (const auto* malformed = std::get_if<wire::Malformed>(&told)) {
    throw CommandError(text_of(server_) + " sent what this program does not understand: " +
                       malformed->fault.field + ": " + malformed->fault.what);
  }
  return std::get<lobby::Told>(std::move(told));
}

Woke Connection::fill(Milliseconds patience, int other) {
  const Woke woke = stream_->wait(other, patience);
  if (woke != Woke::stream) return woke;
  std::array<std::uint8_t, 65536> buffer;
  const std::size_t got = stream_->receive(buffer);
  if (got > 0) heard_ = Clock::now();
  received_.insert(received_.end(), buffer.begin(),
                   buffer.begin() + static_cast<std::ptrdiff_t>(got));
  return woke;
}

void Connection::stay_in_touch() {
  // The server takes silence for a dead connection, and so do we: a ping tells both.
  const auto now = Clock::now();
  if (now - heard_ >= patience_.quiet + patience_.answer) {
    throw Lost("nothing has been heard from the server");
  }
  if (now - spoke_ >= patience_.quiet) send(lobby::RequestId{++last_id_}, lobby::Ping{});
}

void Connection::reopen(const std::string& why) {
  notice_("connection lost (" + why + "); trying again");
  const auto since = Clock::now();
  std::string last = why;
  for (Milliseconds wait = patience_.first_retry;;
       wait = std::min(wait * 2, patience_.longest_retry)) {
    if (Clock::now() - since >= patience_.give_up) {
      throw CommandError(text_of(server_) + " stays away: " + last);
    }
    pause(wait);
    try {
      open();
      resume();
      notice_("connected again");
      return;
    } catch (const Lost& lost) {
      last = lost.what();
    }
  }
}

// ---- What is told

void Connection::note(const lobby::Request& request, const lobby::Answer& answer) {
  if (const auto* news = std::get_if<lobby::MatchNews>(&answer)) {
    Following f{news->info.id, news->info.code, news->you.has_value(), match::Seq{}};
    if (const auto* join = std::get_if<lobby::Join>(&request)) f.next = join->from;
    if (const auto* watch = std::get_if<lobby::Watch>(&request)) {
      f.next = watch->from;
      if (watch->code) f.code = watch->code;
    }
    following_ = f;
  } else if (const auto* leave = std::get_if<lobby::Leave>(&request)) {
    if (following_ && following_->match == leave->match) following_.reset();
  } else if (const auto* entry = std::get_if<lobby::EntryNews>(&answer)) {
    hear(*entry);
  }
}

void Connection::hear(const lobby::Answer& answer) {
  if (const auto* bye = std::get_if<lobby::Goodbye>(&answer)) {
    if (!may_return(bye->reason)) throw CommandError(text_of(server_) + ": " + bye->what);
    throw Lost(bye->what);
  }
  if (const auto* entry = std::get_if<lobby::EntryNews>(&answer)) return hear(*entry);
  if (!following_) return;
  if (const auto* news = std::get_if<lobby::MatchNews>(&answer)) {
    if (news->info.id == following_->match) news_.emplace_back(*news);
  } else if (const auto* gone = std::get_if<lobby::MatchGone>(&answer)) {
    if (gone->match == following_->match) news_.emplace_back(*gone);
  }
}

void Connection::hear(const lobby::EntryNews& news) {
  if (!following_ || news.match != following_->match) return;
  // After a resumption an entry may come twice: as the match so far, and as the answer to the
  // command that is asked again.
  if (news.entry->seq < following_->next) return;
  if (news.entry->seq > following_->next) throw Lost("the server left out a part of the match");
  following_->next = match::Seq{static_cast<std::uint32_t>(following_->next) + 1};
  news_.emplace_back(news.entry);
}

}  // namespace breakshot::client
