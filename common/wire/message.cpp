#include "common/wire/message.hpp"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <google/protobuf/stubs/logging.h>
#include <google/protobuf/unknown_field_set.h>

#include <stdexcept>
#include <string>

#include "common/record/text.hpp"

namespace breakshot::wire {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::UnknownField;
using google::protobuf::UnknownFieldSet;

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const record::Character next = record::first_of(text);
    if (next.bytes == 0) return false;
    text.remove_prefix(next.bytes);
  }
  return true;
}

/// The path of the first text that is no UTF-8. Protobuf itself only says that the whole message
/// cannot be read. Messages are as deep as their types, which do not contain themselves.
std::optional<std::string> field_of_bad_text(std::string_view bytes, const Descriptor& type) {
  UnknownFieldSet fields;
  if (!fields.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return std::nullopt;
  for (int i = 0; i < fields.field_count(); ++i) {
    const UnknownField& field = fields.field(i);
    const FieldDescriptor* known = type.FindFieldByNumber(field.number());
    if (known == nullptr || field.type() != UnknownField::TYPE_LENGTH_DELIMITED) continue;
    const std::string& content = field.length_delimited();
    if (known->type() == FieldDescriptor::TYPE_STRING && !is_utf8(content)) return known->name();
    if (known->type() != FieldDescriptor::TYPE_MESSAGE) continue;
    if (const auto inside = field_of_bad_text(content, *known->message_type())) {
      return known->name() + '.' + *inside;
    }
  }
  return std::nullopt;
}

}  // namespace

ByteVector frame_of_message(const google::protobuf::Message& message) {
  const std::size_t size = message.ByteSizeLong();
  if (size > max_answer_frame) {
    throw std::logic_error("a message of " + std::to_string(size) + " bytes fits into no frame");
  }
  ByteVector frame(frame_header_bytes + size);
  const auto header = frame_header(static_cast<std::uint32_t>(size));
  std::copy(header.begin(), header.end(), frame.begin());
  message.SerializeWithCachedSizesToArray(frame.data() + frame_header_bytes);
  return frame;
}

std::optional<physics::Fault> parse(hash::Bytes body, google::protobuf::Message& message) {
  // Otherwise protobuf prints to standard error what hostile bytes make it say.
  const google::protobuf::LogSilencer silence;
  if (message.ParseFromArray(body.data(), static_cast<int>(body.size()))) return std::nullopt;
  const std::string_view bytes(reinterpret_cast<const char*>(body.data()), body.size());
  const Descriptor& type = *message.GetDescriptor();
  if (const auto field = field_of_bad_text(bytes, type)) {
    return physics::Fault{*field, "is no UTF-8; a text must be"};
  }
  return physics::Fault{"message", "is no protobuf message " + type.full_name()};
}

}  // namespace breakshot::wire
