#include "pongsim/geometry/geodesy.hh"

#include <cmath>

#include "pongsim/math.hh"

namespace pongsim {

namespace {

// WGS84: equatorial radius [m], flattening, and the square of the first eccentricity that follows from it
constexpr double kRadius = 6378137.0;
constexpr double kFlattening = 1 / 298.257223563;
constexpr double kEccentricity2 = kFlattening * (2 - kFlattening);

/// Radius of curvature in the prime vertical [m].
double curvature(double latitude) {
  const double sine = math::sin(latitude);
  return kRadius / std::sqrt(1 - kEccentricity2 * sine * sine);
}

Vector3 toEarth(const GeodeticPosition& place) {
  const double n = curvature(place.latitude);
  const double across = (n + place.altitude) * math::cos(place.latitude);
  return {across * math::cos(place.longitude), across * math::sin(place.longitude),
          (n * (1 - kEccentricity2) + place.altitude) * math::sin(place.latitude)};
}

GeodeticPosition fromEarth(const Vector3& position) {
  const double across = math::hypot(position.x(), position.y());
  // each iteration reduces the error by a factor of about 150; Hofmann-Wellenhof, Lichtenegger, Collins: GPS, Theory
  // and Practice, 10.2.1, with a formula for the height that also works at the poles
  double latitude = math::atan2(position.z(), across * (1 - kEccentricity2));
  for (int i = 0; i < 10; ++i) {
    latitude = math::atan2(position.z() + kEccentricity2 * curvature(latitude) * math::sin(latitude), across);
  }
  const double sine = math::sin(latitude);
  const double altitude =
      across * math::cos(latitude) + position.z() * sine - kRadius * std::sqrt(1 - kEccentricity2 * sine * sine);
  return {latitude, math::atan2(position.y(), position.x()), altitude};
}

}  // namespace

TangentPlane::TangentPlane(const GeodeticPosition& origin, double heading) : origin_(toEarth(origin)) {
  const double sinLat = math::sin(origin.latitude), cosLat = math::cos(origin.latitude);
  const double sinLon = math::sin(origin.longitude), cosLon = math::cos(origin.longitude);
  Matrix3 R_EarthEnu;
  R_EarthEnu.col(0) = Vector3(-sinLon, cosLon, 0);
  R_EarthEnu.col(1) = Vector3(-sinLat * cosLon, -sinLat * sinLon, cosLat);
  R_EarthEnu.col(2) = Vector3(cosLat * cosLon, cosLat * sinLon, sinLat);
  R_EarthLocal_ = R_EarthEnu * fromRollPitchYaw(0, 0, heading).toRotationMatrix();
}

GeodeticPosition TangentPlane::at(const Vector3& position) const {
  return fromEarth(origin_ + R_EarthLocal_ * position);
}

Vector3 TangentPlane::positionOf(const GeodeticPosition& place) const {
  return R_EarthLocal_.transpose() * (toEarth(place) - origin_);
}

}  // namespace pongsim
