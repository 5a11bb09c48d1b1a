// A server of one match for tests of the client: enough of the protocol to be played against, and
// it can be told to cut the connection at any one step.
#pragma once

#include <algorithm>
#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "common/lobby/lobby.hpp"
#include "common/match/match.hpp"
#include "common/physics/table.hpp"
#include "common/record/record.hpp"
#include "tests/support/loopback_server.hpp"

namespace breakshot::client {

/// A practice of one seat, which starts as soon as its player has contributed.
class OneMatchServer {
 public:
  /// Every request received is a step, and so is everything told. At
  /// step number `cut_at`, once, the connection is closed instead.
  explicit OneMatchServer(int cut_at = 0)
      : cut_at_(cut_at), server_([this](support::Peer& peer) { serve(peer); }) {}

  std::uint16_t port() const { return server_.port(); }
  int steps() const { return steps_; }
  bool has_cut() const { return cut_at_ > 0 && steps_ >= cut_at_; }

  static inline const lobby::Token token = {1, 2, 3};

 private:
  static inline const match::MatchId id_{0x1234};

  /// Whether this step is the one at which to cut.
  bool cuts() { return ++steps_ == cut_at_; }

  void serve(support::Peer& peer) {
    told_ = 0;
    while (const auto asked = peer.hear()) {
      if (cuts()) return;
      if (const auto* fetch = std::get_if<lobby::Fetch>(&asked->request)) {
        if (!tell_record(peer, asked->id, static_cast<std::size_t>(fetch->from))) return;
        continue;
      }
      const auto answer = std::visit([&](const auto& r) { return carry_out(r); }, asked->request);
      if (cuts()) return;
      peer.tell(asked->id, answer);
      if (const auto* own = std::get_if<lobby::EntryNews>(&answer)) {
        told_ = std::max(told_, static_cast<std::size_t>(own->entry->seq) + 1);
      }
      for (; following_ && told_ < entries_.size(); ++told_) {
        if (cuts()) return;
        peer.tell(lobby::RequestId{0}, lobby::EntryNews{id_, entries_[told_]});
      }
    }
  }

  bool tell_record(support::Peer& peer, lobby::RequestId id, std::size_t from) {
    if (cuts()) return false;
    peer.tell(id, news());
    for (; from < entries_.size(); ++from) {
      if (cuts()) return false;
      peer.tell(id, lobby::EntryNews{id_, entries_[from]});
    }
    if (cuts()) return false;
    peer.tell(id, lobby::FetchDone{id_, match_.next});
    return true;
  }

  lobby::Answer carry_out(const lobby::Hello& hello) {
    following_ = false;
    if (hello.token && *hello.token != token) return refused(lobby::RefusalCode::unknown_token);
    const auto given = hello.token ? std::nullopt : std::optional<lobby::Token>(token);
    return lobby::Welcome{hello.name, given, "test", 1000};
  }
  lobby::Answer carry_out(const lobby::Create&) {
    following_ = true;
    return news();
  }
  lobby::Answer carry_out(const lobby::Join& join) { return follow(join.from); }
  lobby::Answer carry_out(const lobby::Watch& watch) { return follow(watch.from); }
  lobby::Answer carry_out(const lobby::List&) { return lobby::Listing{{news().info}, false}; }
  lobby::Answer carry_out(const lobby::Contribute& contribute) {
    contribution_ = contribute.contribution;
    if (entries_.empty()) append({std::nullopt}, match::CommandId{0}, match::Start{});
    return lobby::Done{};
  }
  lobby::Answer carry_out(const lobby::Act& act) {
    for (const auto& entry : entries_) {
      if (entry->id == act.id && entry->seq == act.expected) return lobby::EntryNews{id_, entry};
    }
    if (act.expected != match_.next) return refused(lobby::RefusalCode::command);
    if (!append({match::Seat{0}}, act.id, act.command)) {
      return refused(lobby::RefusalCode::command);
    }
    return lobby::EntryNews{id_, entries_.back()};
  }
  lobby::Answer carry_out(const lobby::Ping&) { return lobby::Done{}; }
  lobby::Answer carry_out(const lobby::Leave&) {
    following_ = false;
    return lobby::Done{};
  }
  lobby::Answer carry_out(const lobby::Fetch&) { return refused(lobby::RefusalCode::wrong_stage); }
  lobby::Answer carry_out(const lobby::Claim&) { return refused(lobby::RefusalCode::too_early); }

  lobby::Answer follow(match::Seq from) {
    following_ = true;
    told_ = static_cast<std::size_t>(from);
    return news();
  }

  lobby::Refused refused(lobby::RefusalCode code) const {
    const bool command = code == lobby::RefusalCode::command;
    return {code, command ? std::optional(match::RefusalCode::not_allowed_now) : std::nullopt,
            "not like this"};
  }

  lobby::MatchNews news() const {
    lobby::MatchNews news;
    news.info.id = id_;
    news.info.settings = match_.settings;
    news.info.stage = match_.status.stage;
    news.info.seats = {{"Ann", contribution_.has_value(), true, 0}};
    news.info.score = match_.status.score;
    news.info.next = match_.next;
    news.you = match::Seat{0};
    if (contribution_) {
      news.header = record::Header{record::format_version, physics::physics_version,  id_, 0,
                                   match_.settings,        {{"Ann", *contribution_}}, {}};
    }
    return news;
  }

  bool append(const match::Author& author, match::CommandId id, const match::Command& command) {
    auto result = match::apply(match_, {author, match_.next, command});
    auto* accepted = std::get_if<match::Accepted>(&result);
    if (accepted == nullptr) return false;
    entries_.push_back(std::make_shared<const record::Entry>(
        record::Entry{match_.next, author, id, command, accepted->outcome, std::nullopt, {}}));
    match_ = std::move(accepted->next);
    return true;
  }

  static match::Match practice() {
    const auto& preset = physics::presets().front();
    return match::created({std::string(preset.name), preset.scene, match::GameKind::practice, 1, 1},
                          {});
  }

  int cut_at_;
  std::atomic<int> steps_{0};
  std::optional<match::Contribution> contribution_;
  match::Match match_ = practice();
  std::vector<std::shared_ptr<const record::Entry>> entries_;
  bool following_ = false;
  std::size_t told_ = 0;  ///< entries that the connection has been told
  support::LoopbackServer server_;
};

}  // namespace breakshot::client
