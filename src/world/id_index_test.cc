#include "world/id_index.hh"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace pongsim::world {
namespace {

TEST(IdIndex, FindsWhatIsThereAndNothingElse) {
  IdIndex index;
  EXPECT_EQ(index.find(1), IdIndex::kNowhere);
  for (std::uint64_t id = 1; id <= 1000; ++id) index.add(3 * id, id);
  // some that are far away
  for (std::uint64_t id = 1; id <= 100; ++id) index.add(id << 14U | 3, 2000 + id);
  for (std::uint64_t id = 1; id <= 1000; ++id) {
    EXPECT_EQ(index.find(3 * id), id);
    EXPECT_EQ(index.find(3 * id + 1), IdIndex::kNowhere);
  }
  for (std::uint64_t id = 1; id <= 100; ++id) EXPECT_EQ(index.find(id << 14U | 3), 2000 + id);
  EXPECT_EQ(index.find(0), IdIndex::kNowhere);
  EXPECT_EQ(index.find(1ULL << 60U), IdIndex::kNowhere);
}

TEST(IdIndex, ForgetsWhatGoesAndKnowsWhatMoves) {
  IdIndex index;
  std::vector<std::uint64_t> ids;
  for (std::uint64_t id = 1; id <= 300; ++id) ids.push_back(id % 3 == 0 ? id << 14U | 5 : id);
  for (const std::uint64_t id : ids) index.add(id, id);
  for (std::size_t i = 0; i < ids.size(); i += 2) index.remove(ids[i]);
  for (std::size_t i = 1; i < ids.size(); i += 2) index.move(ids[i], i);
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(index.find(ids[i]), i % 2 == 0 ? IdIndex::kNowhere : i);
  for (std::size_t i = 0; i < ids.size(); i += 2) index.add(ids[i], i);
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(index.find(ids[i]), i);
}

TEST(IdIndex, IsEmptyAfterClearing) {
  IdIndex index;
  index.add(7, 1);
  index.clear();
  EXPECT_EQ(index.find(7), IdIndex::kNowhere);
  index.add(7, 2);
  EXPECT_EQ(index.find(7), 2U);
}

}  // namespace
}  // namespace pongsim::world
