#include "common/record/bytes.hpp"
#include "common/record/describe_record.hpp"
#include "common/record/record.hpp"
#include "common/record/shape.hpp"

namespace breakshot::record {
namespace {

template <class T>
Writer written(const T& value) {
  Writer writer;
  describe(writer, value);
  return writer;
}

template <class T>
std::variant<T, Damage> read(hash::Bytes bytes) {
  Reader reader(bytes);
  T value;
  describe(reader, value);
  reader.end();
  if (reader.failed()) return *reader.damage();
  return value;
}

template <class T>
std::optional<std::string> encoding_fault(const T& value) {
  const Writer writer = written(value);
  if (!writer.failed()) return std::nullopt;
  return writer.damage()->what;
}

}  // namespace

std::optional<std::string> fault_of(const Header& header) {
  return encoding_fault(header);
}

std::optional<std::string> fault_of(const Header& header, const Entry& entry) {
  const auto fault = encoding_fault(entry);
  return fault ? fault : shape_fault(header, entry);
}

ByteVector encode(const Header& header) {
  return written(header).taken("the header");
}

ByteVector encode(const Entry& entry) {
  Writer writer = written(entry);
  writer.raw(entry.digest);
  return std::move(writer).taken("the entry");
}

ByteVector encode(const match::Settings& settings) {
  return written(settings).taken("the settings");
}

std::variant<Header, Damage> decode_header(hash::Bytes bytes) {
  return read<Header>(bytes);
}

std::variant<match::Settings, Damage> decode_settings(hash::Bytes bytes) {
  return read<match::Settings>(bytes);
}

std::variant<Entry, Damage> decode_entry(hash::Bytes bytes) {
  Reader reader(bytes);
  Entry entry;
  describe(reader, entry);
  field(reader, "digest", entry.digest);
  reader.end();
  if (reader.failed()) return *reader.damage();
  return entry;
}

hash::Digest digest_of(const Header& header) {
  return hash::sha256(encode(header));
}

hash::Digest digest_of(const hash::Digest& before, const Entry& entry) {
  Writer writer;
  writer.raw(before);
  describe(writer, entry);
  return hash::sha256(std::move(writer).taken("the entry"));
}

}  // namespace breakshot::record
