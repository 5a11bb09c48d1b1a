// The thread with a queue that the store is made of.
#include "server/store/worker.hpp"

#include <gtest/gtest.h>

#include <future>

namespace breakshot::store {
namespace {

TEST(Worker, GroupsWhatCameMeanwhileInOrderAndWithinItsLimit) {
  std::promise<void> go;
  std::vector<std::vector<int>> groups;
  {
    Worker<int> worker(4, [&](std::vector<int> group) {
      if (groups.empty()) go.get_future().wait();
      groups.push_back(std::move(group));
    });
    for (int i = 0; i < 11; ++i) worker.give(i);
    go.set_value();
  }
  std::vector<int> all;
  for (const auto& group : groups) {
    EXPECT_LE(group.size(), 4u);
    EXPECT_FALSE(group.empty());
    all.insert(all.end(), group.begin(), group.end());
  }
  EXPECT_EQ(all, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
  EXPECT_LE(groups.size(), 5u) << "ten waited while the first was carried out, so they share";
}

TEST(Worker, ItsEndWaitsForAllWork) {
  int done = 0;
  {
    Worker<int> worker(1, [&](const std::vector<int>&) { ++done; });
    for (int i = 0; i < 100; ++i) worker.give(i);
  }
  EXPECT_EQ(done, 100);
}

}  // namespace
}  // namespace breakshot::store
