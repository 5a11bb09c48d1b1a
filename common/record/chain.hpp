// How entries follow one another: by number, by digest, and the secret only in the last.
#pragma once

#include <optional>
#include <string>

#include "common/record/record.hpp"

namespace breakshot::record {

class Chain {
 public:
  /// `header` must be free of faults and outlive the chain.
  explicit Chain(const Header& header) : header_(header), digest_(digest_of(header)) {}

  /// Why `entry` cannot be the next one, its digest aside.
  std::optional<std::string> place_fault(const Entry& entry) const;
  /// Appends `entry`, which has its place, or says why its digest is not the one that follows.
  std::optional<std::string> append(const Entry& entry);

 private:
  const Header& header_;
  hash::Digest digest_;
  std::uint32_t next_ = 0;
  bool revealed_ = false;
};

}  // namespace breakshot::record
