#pragma once

#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// The points that a vehicle visits, as a plugin's `<waypoints>`, `<circle>` or `<line>` says.
class Path {
 public:
  /// Of several the first that stands above counts, as in Fortress; the others are warned of.
  /// @throws Error where none of them is there, or one says nothing that can be used.
  static Path read(const Element& plugin, Diagnostics& diagnostics);

  /// @param X_WorldStart Where the vehicle starts, around or from where a circle or a line goes.
  /// @return The points in the world frame, z = 0; at least one.
  std::vector<Vector3> points(const Pose& X_WorldStart) const;

 private:
  enum class Kind { kWaypoints, kCircle, kLine };

  Kind kind_ = Kind::kWaypoints;
  std::vector<Vector3> waypoints_;
  /// Of the circle, or length of the line [m].
  double length_ = 0;
  /// Of the line, from the x axis of the vehicle [rad].
  double direction_ = 0;
};

}  // namespace pongsim
