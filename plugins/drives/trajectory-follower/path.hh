#pragma once

#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// The points that a vehicle visits, from a plugin's `<waypoints>`, `<circle>` or `<line>`.
class Path {
 public:
  /// If there are several, the first one in this order is used, as in Fortress, with a warning.
  /// @throws Error if there is none, or it is invalid.
  static Path read(const Element& plugin, Diagnostics& diagnostics);

  /// @param X_WorldStart Start of the vehicle, the centre of a circle or the start of a line.
  /// @return The points in the world frame, z = 0; at least one.
  std::vector<Vector3> points(const Pose& X_WorldStart) const;

 private:
  enum class Kind { kWaypoints, kCircle, kLine };

  Kind kind_ = Kind::kWaypoints;
  std::vector<Vector3> waypoints_;
  /// Radius of the circle or length of the line [m].
  double length_ = 0;
  /// Direction of the line, from the x axis of the vehicle [rad].
  double direction_ = 0;
};

}  // namespace pongsim
