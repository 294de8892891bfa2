#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/state/state_archive.hh"

namespace pongsim {

/// A cell of a grid, by its column and row.
struct Cell {
  int x = 0;
  int y = 0;
  bool operator==(const Cell&) const = default;
};

/// A map of what a lidar has seen: cells that are free, occupied, or unknown.
class OccupancyGrid {
 public:
  enum class State : std::uint8_t { kUnknown, kFree, kOccupied };

  OccupancyGrid() = default;
  /// @param width, height Columns and rows; at most `kMostCells` together.
  /// @param resolution Side length of a cell [m].
  /// @param originX, originY The corner with the lowest coordinates, world frame [m].
  OccupancyGrid(int width, int height, double resolution, double originX, double originY);

  static constexpr int kMostCells = 1'000'000;

  int width() const { return width_; }
  int height() const { return height_; }
  /// @return The state of a cell; nothing outside of the grid.
  std::optional<State> at(Cell cell) const;
  /// @return The cell at a place; may be outside of the grid.
  Cell cellAt(double x, double y) const;
  /// @return Its centre, world frame [m].
  double centerX(Cell cell) const { return originX_ + (cell.x + 0.5) * resolution_; }
  double centerY(Cell cell) const { return originY_ + (cell.y + 0.5) * resolution_; }

  /// Marks the unknown cells on the way from one place to another as free. The last one is occupied if something was
  /// hit there; otherwise it is free, too.
  void mark(double fromX, double fromY, double toX, double toY, bool isHit);

  /// @return The number of unknown cells that a beam from a cell would see, up to an occupied cell or the border.
  int unknownOn(Cell from, Cell to) const;

  /// @return The free cells beside unknown ones, but not beside occupied ones, that free cells connect with `start`.
  /// Near what is occupied, a free cell may be partly in it.
  std::vector<Cell> frontier(Cell start) const;

  /// @return A picture, three bytes for each cell, beginning with the highest row: free cells are white, occupied ones
  /// black, others grey.
  std::string picture() const;

  void transfer(StateArchive& archive);

 private:
  std::size_t indexOf(Cell cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(cell.x);
  }
  bool contains(Cell cell) const { return cell.x >= 0 && cell.x < width_ && cell.y >= 0 && cell.y < height_; }

  int width_ = 0;
  int height_ = 0;
  double resolution_ = 1;
  double originX_ = 0;
  double originY_ = 0;
  std::vector<State> cells_;
};

}  // namespace pongsim
