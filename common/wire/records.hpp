// Records between their protobuf messages and the domain. The digest is carried, not checked.
#pragma once

#include "breakshot/v1/record.pb.h"
#include "common/record/record.hpp"
#include "common/wire/check.hpp"

namespace breakshot::wire {

void write(const record::Header& header, v1::Header& message);
record::Header read(const v1::Header& message, const Where& at);

void write(const record::Entry& entry, v1::Entry& message);
record::Entry read(const v1::Entry& message, const Where& at);

}  // namespace breakshot::wire
