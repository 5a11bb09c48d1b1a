#include "server/ledger/ledger.hpp"

namespace breakshot::ledger {

Progress progress_after(const record::Entry& entry) {
  const match::Status& status = entry.outcome.status;
  const match::Seq next{static_cast<std::uint32_t>(entry.seq) + 1};
  return {status.stage, next, status.score, status.winner, status.end};
}

}  // namespace breakshot::ledger
