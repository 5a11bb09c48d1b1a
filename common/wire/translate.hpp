// Messages: what is asked and told, between bytes and values. Nothing that comes out of here can
// surprise the domain: hostile bytes give a fault that names the field and says what would be
// right, never an exception.
#pragma once

#include <optional>
#include <variant>

#include "common/hash/hash.hpp"
#include "common/lobby/lobby.hpp"
#include "common/physics/scene.hpp"
#include "common/wire/frame.hpp"

namespace breakshot::wire {

/// A body that could not be read. `fault.field` is the path of the field, as in the .proto files
/// ("act.command.shoot.speed_m_s"), or "message" for the whole.
struct Malformed {
  /// The request that was meant, if at least that could be read: it can be refused. Otherwise the
  /// bytes are not of this protocol.
  std::optional<lobby::RequestId> id;
  physics::Fault fault;
};

/// What a client asks: a whole frame, header and body. A request that names a match must have its
/// id or its code.
ByteVector frame_of(const lobby::Asked& asked);
/// The body of a frame from a client.
std::variant<lobby::Asked, Malformed> read_asked(hash::Bytes body);

/// What a server tells: a whole frame, header and body.
ByteVector frame_of(const lobby::Told& told);
/// The body of a frame from a server. Entries are whole and well-formed, so they can be drawn; that
/// their digests are right is for `record` to check.
std::variant<lobby::Told, Malformed> read_told(hash::Bytes body);

}  // namespace breakshot::wire
