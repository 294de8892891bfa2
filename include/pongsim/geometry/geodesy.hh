#pragma once

#include "pongsim/export.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// A place on the earth (WGS84).
struct GeodeticPosition {
  /// [rad], positive in the north.
  double latitude = 0;
  /// [rad], positive in the east, above -pi and up to pi.
  double longitude = 0;
  /// Above the ellipsoid [m].
  double altitude = 0;
};

/// A frame tangent to the earth: x points east and y north, both rotated by a heading; z points up.
class PONGSIM_API TangentPlane {
 public:
  /// @param heading Angle from east to the x axis, anticlockwise [rad].
  TangentPlane(const GeodeticPosition& origin, double heading);

  /// @param position In this frame [m].
  GeodeticPosition at(const Vector3& position) const;

  /// @return The place's position in this frame [m].
  Vector3 positionOf(const GeodeticPosition& place) const;

 private:
  /// In the frame fixed to the earth: x to the zero meridian, z to the north pole.
  Vector3 origin_;
  Matrix3 R_EarthLocal_;
};

}  // namespace pongsim
