#include <algorithm>
#include <array>

#include "common/record/bytes.hpp"
#include "common/record/chain.hpp"
#include "common/record/record.hpp"

namespace breakshot::record {
namespace {

// The first byte is no text, and the line ends show a copy that has rewritten them.
constexpr std::array<std::uint8_t, 14> magic{0x89, 'B', 'R', 'E',  'A',  'K',  'S',
                                             'H',  'O', 'T', '\r', '\n', 0x1a, '\n'};

void write_counted(Writer& writer, const ByteVector& bytes) {
  std::size_t size = bytes.size();
  writer.count(size, unlimited);
  writer.raw(bytes);
}

/// Counted bytes within the file, and where they begin.
struct Part {
  hash::Bytes bytes;
  std::size_t offset = 0;
};

Part read_counted(Reader& reader) {
  std::size_t size = 0;
  reader.count(size, unlimited);
  const std::size_t offset = reader.offset();
  return {reader.take(size), offset};
}

Damage within(const Part& part, const Damage& damage, const std::string& name) {
  return {part.offset + damage.offset, name + ": " + damage.what};
}

std::optional<Damage> magic_damage(hash::Bytes file) {
  const auto [found, expected] =
      std::mismatch(file.begin(), file.end(), magic.begin(), magic.end());
  if (expected == magic.end()) return std::nullopt;
  return Damage{static_cast<std::size_t>(found - file.begin()),
                "not a breakshot file, or a damaged one: the first " +
                    std::to_string(magic.size()) + " bytes should be " + hash::hex_of(magic)};
}

std::variant<Header, Damage> read_header(Reader& reader) {
  const Part part = read_counted(reader);
  hash::Digest digest{};
  const std::size_t digest_offset = reader.offset();
  if (!reader.failed()) {
    auto decoded = decode_header(part.bytes);
    if (auto* damage = std::get_if<Damage>(&decoded)) return within(part, *damage, "header");
    reader.raw(digest);
    if (!reader.failed()) {
      if (digest == digest_of(std::get<Header>(decoded))) return decoded;
      return Damage{digest_offset, "header: its bytes do not have the digest stored here"};
    }
  }
  return Damage{reader.damage()->offset, "header: " + reader.damage()->what};
}

/// Appends entries until the end mark, an empty entry; or says what is wrong with the first that
/// cannot be appended.
std::optional<Damage> read_entries(Reader& reader, Record& record) {
  Chain chain(record.header);
  while (true) {
    const std::string name = "entry " + std::to_string(record.entries.size());
    const Part part = read_counted(reader);
    if (reader.failed()) {
      return Damage{reader.damage()->offset, name + ": " + reader.damage()->what};
    }
    if (part.bytes.empty()) break;
    const auto decoded = decode_entry(part.bytes);
    if (const auto* damage = std::get_if<Damage>(&decoded)) return within(part, *damage, name);
    const Entry& entry = std::get<Entry>(decoded);
    auto fault = chain.place_fault(entry);
    if (!fault) fault = chain.append(entry);
    if (fault) return Damage{part.offset, name + ": " + *fault};
    record.entries.push_back(entry);
  }
  reader.end();
  return reader.damage();
}

}  // namespace

ByteVector file_of(const Record& record) {
  Writer writer;
  writer.raw(magic);
  write_counted(writer, encode(record.header));
  writer.raw(digest_of(record.header));
  for (const Entry& entry : record.entries) write_counted(writer, encode(entry));
  write_counted(writer, {});
  return std::move(writer).taken("the file");
}

Reading read_file(hash::Bytes bytes) {
  Reading reading;
  reading.damage = magic_damage(bytes);
  if (reading.damage) return reading;
  Reader reader(bytes);
  reader.take(magic.size());
  auto header = read_header(reader);
  if (auto* damage = std::get_if<Damage>(&header)) {
    reading.damage = std::move(*damage);
    return reading;
  }
  reading.record = Record{std::get<Header>(std::move(header)), {}};
  reading.damage = read_entries(reader, *reading.record);
  return reading;
}

}  // namespace breakshot::record
