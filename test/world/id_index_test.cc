#include "world/id_index.hh"

#include <gtest/gtest.h>

namespace pongsim::world {
namespace {

TEST(IdIndex, FindsWhatIsThereAndNothingElse) {
  IdIndex index;
  EXPECT_EQ(index.find(1), IdIndex::kNowhere);
  for (std::uint64_t id = 1; id <= 1000; ++id) index.add(3 * id, id);
  // some that fall on the same places of the table
  for (std::uint64_t id = 1; id <= 100; ++id) index.add(id << 40U | 3, 2000 + id);
  for (std::uint64_t id = 1; id <= 1000; ++id) {
    EXPECT_EQ(index.find(3 * id), id);
    EXPECT_EQ(index.find(3 * id + 1), IdIndex::kNowhere);
  }
  for (std::uint64_t id = 1; id <= 100; ++id) EXPECT_EQ(index.find(id << 40U | 3), 2000 + id);
  EXPECT_EQ(index.find(0), IdIndex::kNowhere);
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
