#include "client_cli/online/teller.hpp"

#include <string>
#include <variant>

#include "client_cli/draw/abilities.hpp"
#include "client_cli/paragraph.hpp"
#include "client_cli/words.hpp"

namespace breakshot::client {
namespace {

const char* word_of(match::Stage stage) {
  switch (stage) {
    case match::Stage::gathering:
      return "open";
    case match::Stage::running:
      return "running";
    case match::Stage::finished:
      break;
  }
  return "finished";
}

Json json_of(const lobby::SeatInfo& seat) {
  return object({{"name", seat.name},
                 {"contributed", seat.contributed},
                 {"present", seat.present},
                 {"awayMs", seat.away_ms}});
}

bool is_taken(const lobby::SeatInfo& seat) {
  return !seat.name.empty();
}

}  // namespace

Json json_of(const lobby::MatchInfo& info) {
  const bool is_practice = info.settings.game == match::GameKind::practice;
  return object({{"match", words_of(info.id)},
                 {"stage", word_of(info.stage)},
                 {"game", is_practice ? "practice" : "8-ball"},
                 {"preset", info.settings.preset},
                 {"raceTo", info.settings.race_to},
                 {"seats", array_of(info.seats, [](const auto& seat) { return json_of(seat); })},
                 {"score", array_of(info.score, [](std::uint32_t racks) { return Json(racks); })},
                 {"entries", static_cast<std::uint32_t>(info.next)},
                 {"winner", info.winner ? Json(rules::number(*info.winner)) : Json()},
                 {"private", info.is_private},
                 {"code", info.code},
                 {"createdUnixMs", info.created_unix_ms}});
}

std::string join_line(const lobby::MatchInfo& info, const std::string& server) {
  const std::string which = info.code ? "--code " + *info.code : words_of(info.id);
  return "breakshot play " + which + " --server " + server;
}

std::vector<std::string> seat_changes(const std::vector<lobby::SeatInfo>& before,
                                      const std::vector<lobby::SeatInfo>& after) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const lobby::SeatInfo was = i < before.size() ? before[i] : lobby::SeatInfo{};
    const lobby::SeatInfo& is = after[i];
    if (is_taken(was) && was.name != is.name) lines.push_back(was.name + " gets up.");
    if (is_taken(is) && was.name != is.name) lines.push_back(is.name + " sits down.");
    if (was.name != is.name || !is_taken(is) || was.present == is.present) continue;
    lines.push_back(is.name + (is.present ? " is back." : " is away."));
  }
  return lines;
}

void Teller::begin(const MatchView& view, const std::string& server) {
  if (json_) {
    say(json_of(view.info).text());
  } else if (view.info.stage == match::Stage::gathering && view.you && has_free_seat(view.info)) {
    say("Match " + words_of(view.info.id) + " is open. Others join with:");
    say("  " + join_line(view.info, server));
  }
  seats_ = view.info.seats;
  if (view.header) tell(view, lobby::MatchNews{view.info, view.you, view.header});
  if (json_ || view.info.stage != match::Stage::running) return;
  for (const lobby::SeatInfo& seat : seats_) {
    if (is_taken(seat) && !seat.present) say(seat.name + " is away.");
  }
}

void Teller::tell(const MatchView& view, const News& news) {
  std::visit([&](const auto& one) { tell(view, one); }, news);
}

void Teller::tell(const MatchView&, const lobby::MatchNews& news) {
  const auto changes = seat_changes(seats_, news.info.seats);
  const bool changed = seats_ != news.info.seats;
  seats_ = news.info.seats;
  if (json_) {
    if (changed) say(json_of(news.info).text());
  } else {
    for (const std::string& line : changes) say(line);
  }
  if (account_ || !news.header) return;
  account_.emplace(names_of(*news.header));
  if (!json_) say(match_text(*news.header));
}

void Teller::tell(const MatchView& view, const EntryPtr& entry) {
  // The news with the header comes before the first entry.
  if (!account_ && view.header) account_.emplace(names_of(*view.header));
  if (!account_) return;
  if (json_) {
    say(account_->json_of(*entry).text());
  } else {
    for (const std::string& line : account_->lines_of(*entry)) say(line);
  }
}

void Teller::tell(const MatchView& view, const lobby::MatchGone&) {
  if (json_) {
    say(object({{"match", words_of(view.info.id)}, {"gone", view.gone}}).text());
  } else {
    say("The match is gone: " + view.gone);
  }
}

void Teller::say(const std::string& line) {
  if (!wraps_) {
    out_ << line << '\n' << std::flush;
    return;
  }
  const auto columns = static_cast<std::size_t>(terminal_size().columns);
  // Below the sentences of the account, which stand beside the number of the shot.
  const std::string indent(10, ' ');
  for (const std::string& part : wrapped(line, columns, indent)) out_ << part << '\n';
  out_.flush();
}

}  // namespace breakshot::client
