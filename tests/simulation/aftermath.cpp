#include "tests/simulation/aftermath.hpp"

#include <set>
#include <utility>

#include "tests/simulation/broken.hpp"

namespace breakshot::simulation {

void check_records(const support::Kept& kept) {
  for (const auto& [id, match] : kept.matches) {
    if (!match.row.header) continue;
    record::Record record{*match.row.header, {}};
    for (const auto& entry : match.entries) record.entries.push_back(*entry);
    const bool finished = match.row.progress.stage == match::Stage::finished;
    const auto expected =
        finished ? record::Verdict::Kind::verified : record::Verdict::Kind::not_revealed_yet;
    require(record::verify(record).kind == expected, "a stored match does not verify");
    std::set<match::CommandId> ids;
    for (const record::Entry& entry : record.entries) {
      require(!entry.author.seat || ids.insert(entry.id).second, "a command was played twice");
    }
  }
}

void check_restart(const support::Kept& kept, const hub::Limits& limits, hub::Now now) {
  hub::Hub next("simulated", limits);
  kept.restore([&](ledger::Restored one) {
    bool goes_on = false;
    for (const hub::Output& output : next.step(std::move(one), now)) {
      const auto* note = std::get_if<hub::Note>(&output);
      goes_on = goes_on || (note && std::holds_alternative<hub::MatchRestored>(*note));
    }
    require(goes_on, "a stored match cannot go on");
  });
}

}  // namespace breakshot::simulation
