#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace pongsim::base {

/// Point numbers in the order of a closed line.
using Loop = std::vector<std::uint32_t>;

/// @return Twice the area of the triangle, positive if it is counter-clockwise.
double twiceArea(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

/// @return Whether the segments from a to b and from c to d have a common point.
bool haveCommonPoint(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                     const Eigen::Vector2d& d);

/// @return Whether a closed line encloses the point, which must not be on it.
bool encloses(const std::vector<Eigen::Vector2d>& line, const Eigen::Vector2d& point);

/// Triangulates the area inside closed lines without adding points. Each edge of a line is the edge of one triangle;
/// triangles of points on a straight line have no area.
class Triangulation {
 public:
  explicit Triangulation(const std::vector<Eigen::Vector2d>& points) : points_(points) {}

  /// @param loop Counter-clockwise.
  /// @param holes Inside it, clockwise.
  void add(Loop loop, std::vector<Loop> holes);

  /// @return Whether all holes were found inside their loops.
  bool isComplete() const { return isComplete_; }
  std::vector<std::array<std::uint32_t, 3>> take() { return std::move(triangles_); }

 private:
  const Eigen::Vector2d& at(std::uint32_t index) const { return points_[index]; }
  void join(Loop& loop, const Loop& hole);
  bool opensTo(const Loop& loop, std::size_t i, const Eigen::Vector2d& eye) const;
  bool isSeen(const Loop& loop, const Eigen::Vector2d& point, const Eigen::Vector2d& eye) const;
  void cut(Loop loop);
  bool isEar(const Loop& loop, std::size_t before, std::size_t i, std::size_t after) const;

  const std::vector<Eigen::Vector2d>& points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  bool isComplete_ = true;
};

}  // namespace pongsim::base
