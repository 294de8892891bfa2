#include "occupancy_grid.hh"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace pongsim {

namespace {

/// Far outside of any grid, but far from the limits of whole numbers.
constexpr double kFarthestCell = 1e8;

/// Calls `visit` with the cells of a line (J. Bresenham, Algorithm for Computer Control of a Digital Plotter, IBM
/// Systems Journal 4(1), 1965), from its start on, until it returns false.
template <class Visit>
void forLine(Cell from, Cell to, Visit visit) {
  const int dx = std::abs(to.x - from.x), dy = -std::abs(to.y - from.y);
  const int stepX = from.x < to.x ? 1 : -1, stepY = from.y < to.y ? 1 : -1;
  int error = dx + dy;
  while (visit(from) && !(from == to)) {
    const int doubled = 2 * error;
    if (doubled >= dy) {
      error += dy;
      from.x += stepX;
    }
    if (doubled <= dx) {
      error += dx;
      from.y += stepY;
    }
  }
}

constexpr Cell kNeighbours[] = {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}};

Cell operator+(Cell a, Cell b) { return {a.x + b.x, a.y + b.y}; }

}  // namespace

OccupancyGrid::OccupancyGrid(int width, int height, double resolution, double originX, double originY)
    : width_(width),
      height_(height),
      resolution_(resolution),
      originX_(originX),
      originY_(originY),
      cells_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

std::optional<OccupancyGrid::State> OccupancyGrid::at(Cell cell) const {
  if (!contains(cell)) return std::nullopt;
  return cells_[indexOf(cell)];
}

Cell OccupancyGrid::cellAt(double x, double y) const {
  const auto number = [this](double way) {
    return static_cast<int>(std::clamp(std::floor(way / resolution_), -kFarthestCell, kFarthestCell));
  };
  return {number(x - originX_), number(y - originY_)};
}

void OccupancyGrid::mark(double fromX, double fromY, double toX, double toY, bool isHit) {
  const Cell end = cellAt(toX, toY);
  forLine(cellAt(fromX, fromY), end, [&](Cell cell) {
    if (!contains(cell)) return false;
    State& state = cells_[indexOf(cell)];
    if (isHit && cell == end) {
      state = State::kOccupied;
    } else if (state == State::kUnknown) {
      state = State::kFree;
    }
    return true;
  });
}

int OccupancyGrid::unknownOn(Cell from, Cell to) const {
  int count = 0;
  forLine(from, to, [&](Cell cell) {
    const std::optional<State> state = at(cell);
    if (!state || *state == State::kOccupied) return false;
    if (*state == State::kUnknown) ++count;
    return true;
  });
  return count;
}

std::vector<Cell> OccupancyGrid::frontier(Cell start) const {
  std::vector<Cell> found;
  if (at(start) != State::kFree) return found;
  std::vector<bool> isSeen(cells_.size());
  std::vector<Cell> queue{start};
  isSeen[indexOf(start)] = true;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    bool isAtUnknown = false, isAtOccupied = false;
    const Cell cell = queue[next];
    for (const Cell offset : kNeighbours) {
      const Cell other = cell + offset;
      const std::optional<State> state = at(other);
      isAtUnknown = isAtUnknown || state == State::kUnknown;
      isAtOccupied = isAtOccupied || state == State::kOccupied;
      if (state != State::kFree || isSeen[indexOf(other)]) continue;
      isSeen[indexOf(other)] = true;
      queue.push_back(other);
    }
    if (isAtUnknown && !isAtOccupied) found.push_back(cell);
  }
  return found;
}

std::string OccupancyGrid::picture() const {
  std::string bytes;
  bytes.reserve(3 * cells_.size());
  for (int y = height_ - 1; y >= 0; --y) {
    for (int x = 0; x < width_; ++x) {
      const State state = cells_[indexOf({x, y})];
      const int brightness = state == State::kFree ? 255 : state == State::kOccupied ? 0 : 128;
      bytes.append(3, static_cast<char>(brightness));
    }
  }
  return bytes;
}

void OccupancyGrid::transfer(StateArchive& archive) {
  const std::size_t size = cells_.size();
  archive(originX_);
  archive(originY_);
  std::string cells;
  for (const State state : cells_) cells.push_back(static_cast<char>(state));
  archive(cells);
  if (!archive.isGiving()) return;
  archive.check(cells.size() == size && std::ranges::all_of(cells, [](char cell) { return cell >= 0 && cell <= 2; }));
  std::ranges::transform(cells, cells_.begin(), [](char cell) { return static_cast<State>(cell); });
}

}  // namespace pongsim
