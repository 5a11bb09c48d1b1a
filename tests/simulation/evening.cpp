#include "tests/simulation/evening.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <variant>

namespace breakshot::simulation {

Evening::Evening(std::uint64_t seed, std::vector<std::string> server_options)
    : server_options_(std::move(server_options)), random_(seed) {
  for (const char* name : {"Ada", "Bob", "Eve"}) guests_.emplace_back(name);
  resume();
}

void Evening::resume(const support::Disk& disk) {
  server_.reset();
  server_ = std::make_unique<support::ServerProcess>(BREAKSHOT_SERVER_PROGRAM, data(),
                                                     server_options_, disk);
  for (Guest& guest : guests_) guest.connect(server_->port());
}

void Evening::begin(const lobby::Create& create) {
  for (Guest& guest : guests_) guest.forget_match();
  ada().create(create);
  const auto code = ada().news()->info.code;
  if (code) {
    bob().join(*code);
  } else {
    bob().join(ada().match());
    eve().watch(ada().match());
  }
  for (Guest* player : {&ada(), &bob()}) {
    match::Contribution contribution{};
    for (std::uint8_t& byte : contribution) byte = static_cast<std::uint8_t>(random_.below(256));
    player->ask_for<lobby::Done>(lobby::Contribute{player->match(), contribution});
  }
  for (Guest& guest : guests_) {
    if (guest.news()) guest.await(match::Seq{0});
  }
}

bool Evening::running() const {
  return guests_[0].view().status.stage == match::Stage::running;
}

match::Command Evening::command_of(const Guest& player) {
  if (--commands_left_ < 0) return match::Concede{};
  while (true) {
    const match::Ask ask = random_.sensible(player.view());
    if (ask.author.seat == player.seat() && !std::holds_alternative<match::Concede>(ask.command)) {
      return ask.command;
    }
  }
}

bool Evening::step(const std::function<void()>& said) {
  const match::Seat turn = ada().view().status.game.turn;
  Guest& player = ada().seat() == turn ? ada() : bob();
  const match::Seq seq = player.next();
  // A command may be refused, since not every place is free: then there is another one.
  while (player.next() == seq) {
    const lobby::Act command{player.match(), seq, match::CommandId{random_.below(1U << 30) + 1},
                             command_of(player)};
    const lobby::Answer answer = act(player, command, said);
    const auto* refused = std::get_if<lobby::Refused>(&answer);
    if (refused != nullptr && refused->code == lobby::RefusalCode::unavailable) {
      // Another command may make a smaller entry, for which there is room; this one stays as it is.
      EXPECT_TRUE(act(player, command, {}) == answer);
      return false;
    }
  }
  for (Guest& guest : guests_) {
    if (!guest.news()) continue;
    try {
      guest.await(seq);
    } catch (const Lost&) {
      resume();
      guest.await(seq);
    }
  }
  if (!server_->running()) resume();  // it was killed when everybody knew already
  return true;
}

lobby::Answer Evening::act(Guest& player, const lobby::Act& act,
                           const std::function<void()>& said) {
  try {
    return player.ask(act, said);
  } catch (const Lost&) {
    resume();
    // Whether it had been stored or not: it is played once, and the answer is its entry.
    lobby::Answer answer = player.ask(act);
    if (const auto* news = std::get_if<lobby::EntryNews>(&answer)) {
      EXPECT_EQ(news->entry->seq, act.expected);
      EXPECT_EQ(news->entry->id, act.id);
    }
    return answer;
  }
}

void Evening::finish(int commands) {
  commands_left_ = commands;
  while (running() && step()) {
  }
}

record::Record Evening::checked_record() {
  record::Record record;
  Guest& reader = eve().news() ? eve() : ada();
  for (const auto& [seq, entry] : reader.entries()) record.entries.push_back(*entry);
  record.header = reader.news()->header.value();

  // Fetched anew, by one who has nothing of it yet.
  Guest latecomer("Late");
  latecomer.connect(server_->port());
  const auto code = ada().news()->info.code;
  lobby::Fetch fetch{ada().match(), code, {}};
  latecomer.ask_for<lobby::MatchNews>(fetch);
  latecomer.await(match::Seq{static_cast<std::uint32_t>(record.entries.size() - 1)});
  EXPECT_EQ(latecomer.entries().size(), record.entries.size());
  for (const Guest& guest : guests_) {
    for (const auto& [seq, entry] : guest.entries()) {
      const auto kept = latecomer.entries().find(seq);
      EXPECT_TRUE(kept != latecomer.entries().end() && *kept->second == *entry)
          << "entry " << static_cast<std::uint32_t>(seq) << " was told and is lost";
    }
  }

  const record::ByteVector file = record::file_of(record);
  const record::Reading reading = record::read_file(file);
  EXPECT_FALSE(reading.damage) << reading.damage->what;
  EXPECT_TRUE(reading.record == record);
  const record::Verdict verdict = record::verify(record);
  EXPECT_EQ(verdict.kind, record::Verdict::Kind::verified)
      << (verdict.divergence ? verdict.divergence->what : "");
  EXPECT_EQ(verdict.entries_verified, record.entries.size());
  return record;
}

}  // namespace breakshot::simulation
