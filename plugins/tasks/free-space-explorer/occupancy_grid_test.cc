#include "occupancy_grid.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace pongsim::occupancy_grid_test {
namespace {

using State = OccupancyGrid::State;

// columns 0 to 9 and rows 0 to 4, half a metre each, from (-1, 2) on
OccupancyGrid grid() { return {10, 5, 0.5, -1, 2}; }

TEST(OccupancyGrid, IsUnknownAtFirst) {
  EXPECT_EQ(grid().at({0, 0}), State::kUnknown);
  EXPECT_EQ(grid().at({9, 4}), State::kUnknown);
  EXPECT_EQ(grid().at({10, 0}), std::nullopt);
  EXPECT_EQ(grid().at({0, -1}), std::nullopt);
}

TEST(OccupancyGrid, FindsTheCellOfAPlaceAndThePlaceOfACell) {
  EXPECT_EQ(grid().cellAt(-0.9, 2.1), (Cell{0, 0}));
  EXPECT_EQ(grid().cellAt(0, 4), (Cell{2, 4}));
  EXPECT_EQ(grid().cellAt(-1.1, 1e300), (Cell{-1, 100'000'000}));
  EXPECT_DOUBLE_EQ(grid().centerX({2, 0}), 0.25);
  EXPECT_DOUBLE_EQ(grid().centerY({0, 4}), 4.25);
}

TEST(OccupancyGrid, MarksTheWayOfABeamAndWhatItHits) {
  OccupancyGrid map = grid();
  map.mark(-0.75, 3.25, 1.25, 3.25, true);
  for (int x = 0; x < 4; ++x) EXPECT_EQ(map.at({x, 2}), State::kFree);
  EXPECT_EQ(map.at({4, 2}), State::kOccupied);
  EXPECT_EQ(map.at({5, 2}), State::kUnknown);
  // a beam over it does not take it away, nor does one to the end of the world
  map.mark(-0.75, 3.25, 1e9, 3.25, false);
  EXPECT_EQ(map.at({4, 2}), State::kOccupied);
  EXPECT_EQ(map.at({9, 2}), State::kFree);
}

TEST(OccupancyGrid, CountsWhatABeamWouldSee) {
  OccupancyGrid map = grid();
  EXPECT_EQ(map.unknownOn({0, 0}, {100, 0}), 10);
  EXPECT_EQ(map.unknownOn({0, 0}, {4, 4}), 5);
  map.mark(-0.75, 2.25, 2.25, 2.25, true);
  // free up to the hit in column 6
  EXPECT_EQ(map.unknownOn({0, 0}, {9, 0}), 0);
  EXPECT_EQ(map.unknownOn({7, 0}, {9, 0}), 3);
}

TEST(OccupancyGrid, HasAFrontierWhereFreeCellsEnd) {
  OccupancyGrid map = grid();
  EXPECT_TRUE(map.frontier({2, 2}).empty());
  for (double y = 2.25; y < 4.5; y += 0.5) map.mark(-0.75, y, 1.25, y, true);
  // the columns 0 to 3 are free, 4 is a wall: behind it nothing can be reached
  EXPECT_TRUE(map.frontier({2, 2}).empty());
  OccupancyGrid open = grid();
  for (double y = 2.25; y < 4.5; y += 0.5) open.mark(-0.75, y, 1.25, y, false);
  const std::vector<Cell> frontier = open.frontier({0, 2});
  EXPECT_EQ(frontier.size(), 5U);
  for (const Cell cell : frontier) EXPECT_EQ(cell.x, 4);
  // not beside a wall
  open.mark(1.25, 2.25, 1.75, 2.25, true);
  EXPECT_EQ(open.frontier({0, 2}).size(), 3U);
}

TEST(OccupancyGrid, IsAPictureWithNorthAtTheTop) {
  OccupancyGrid map(2, 2, 1, 0, 0);
  map.mark(0.5, 0.5, 1.5, 0.5, true);
  EXPECT_EQ(map.picture(), std::string("\x80\x80\x80\x80\x80\x80\xff\xff\xff\0\0\0", 12));
}

}  // namespace
}  // namespace pongsim::occupancy_grid_test
