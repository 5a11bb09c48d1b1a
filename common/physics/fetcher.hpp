// Of many balls most of an event would be waiting for memory: what the turns to come ask for is
// fetched before them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/physics/cells.hpp"
#include "common/physics/courses.hpp"
#include "common/physics/entry.hpp"
#include "common/physics/event_heap.hpp"
#include "common/physics/fetch_memory.hpp"

namespace breakshot::physics {

template <class Real>
class Fetcher {
 public:
  Fetcher(const EventHeap<Real>& heap, const Cells<Real>& cells, const Courses<Real>& courses,
          const std::vector<Entry<Real>>& entries)
      : heap_(heap), cells_(cells), courses_(courses), entries_(entries) {}

  /// A ball's turn has come nearer: about `others` are to have theirs before it. First what is the
  /// ball's own is fetched, then what that names, then the neighbours. Each step reads what the
  /// one before has fetched; few balls come so much nearer at once that it is not there yet.
  void operator()(std::size_t others, std::uint32_t ball) {
    constexpr std::size_t near = EventHeap<Real>::branches;
    if (others > near * near * near) return;
    if (others > near * near) {
      heap_.fetch(ball);
      fetch(ball);
    } else if (others > near) {
      fetch_named(ball);
    } else if (others > 1) {
      fetch_neighbours(ball);
    }
  }

 private:
  void fetch(std::uint32_t ball) const {
    fetch_memory(&entries_[ball]);
    courses_.fetch(ball);
  }

  void fetch_named(std::uint32_t ball) const {
    const Entry<Real>& entry = entries_[ball];
    if (crosses(entry, courses_[ball])) {
      cells_.fetch_ahead(entry.place, entry.side);
      return;
    }
    cells_.fetch_beside(entry.place);
    if (entry.due != Due::ball) return;
    heap_.fetch(entry.with);
    fetch(entry.with);
  }

  void fetch_neighbours(std::uint32_t ball) {
    const Entry<Real>& entry = entries_[ball];
    if (crosses(entry, courses_[ball])) {
      cells_.find_ahead(entry.place, entry.side, found_);
      fetch_found();
      return;
    }
    fetch_beside(entry.place);
    if (entry.due == Due::ball) fetch_beside(entries_[entry.with].place);
  }

  void fetch_beside(const Place& place) {
    cells_.find_beside(place, found_);
    fetch_found();
  }
  void fetch_found() const {
    for (const std::uint32_t other : found_) fetch(other);
  }

  const EventHeap<Real>& heap_;
  const Cells<Real>& cells_;
  const Courses<Real>& courses_;
  const std::vector<Entry<Real>>& entries_;
  Gathered found_;  ///< kept for its memory alone
};

}  // namespace breakshot::physics
