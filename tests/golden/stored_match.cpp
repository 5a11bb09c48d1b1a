#include "tests/golden/stored_match.hpp"

#include <fstream>
#include <iterator>

namespace breakshot::golden {

std::string name_of(const std::string& path) {
  return path.substr(path.rfind('/') + 1);
}

record::Reading read_match(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const record::ByteVector bytes{std::istreambuf_iterator<char>(file),
                                 std::istreambuf_iterator<char>()};
  return record::read_file(bytes);
}

std::string digest_of_match(const std::string& path) {
  const record::Reading reading = read_match(path);
  if (reading.damage) return "damaged: " + reading.damage->what;
  const record::Verdict verdict = record::verify(*reading.record);
  if (verdict.divergence) {
    return "diverged at entry " +
           std::to_string(static_cast<std::uint32_t>(verdict.divergence->seq)) + ": " +
           verdict.divergence->what;
  }
  if (verdict.kind != record::Verdict::Kind::verified) return "cannot be verified";
  return hash::hex_of(reading.record->entries.back().digest);
}

}  // namespace breakshot::golden
