// Protobuf messages to frames and back.
#pragma once

#include <google/protobuf/message_lite.h>

#include <optional>

#include "common/hash/hash.hpp"
#include "common/physics/scene.hpp"
#include "common/wire/frame.hpp"

namespace google::protobuf {
class Message;
}

namespace breakshot::wire {

ByteVector frame_of_message(const google::protobuf::Message& message);

/// Fills `message`, or says why the bytes are not one.
std::optional<physics::Fault> parse(hash::Bytes body, google::protobuf::Message& message);

}  // namespace breakshot::wire
