#include "pongsim/geodesy.hh"

#include <cmath>

namespace pongsim {

namespace {

// WGS84: half the diameter at the equator [m], flattening, and the square of the first eccentricity that follows
constexpr double kRadius = 6378137.0;
constexpr double kFlattening = 1 / 298.257223563;
constexpr double kEccentricity2 = kFlattening * (2 - kFlattening);

/// Radius of curvature across the meridian [m].
double curvature(double latitude) {
  const double sine = std::sin(latitude);
  return kRadius / std::sqrt(1 - kEccentricity2 * sine * sine);
}

Vector3 toEarth(const GeodeticPosition& place) {
  const double n = curvature(place.latitude);
  const double across = (n + place.altitude) * std::cos(place.latitude);
  return {across * std::cos(place.longitude), across * std::sin(place.longitude),
          (n * (1 - kEccentricity2) + place.altitude) * std::sin(place.latitude)};
}

GeodeticPosition fromEarth(const Vector3& position) {
  const double across = std::hypot(position.x(), position.y());
  // each round is some 1/150 of the error before; Hofmann-Wellenhof, Lichtenegger, Collins: GPS, Theory and Practice,
  // 10.2.1, with the height taken so that it is good at the poles, too
  double latitude = std::atan2(position.z(), across * (1 - kEccentricity2));
  for (int i = 0; i < 10; ++i) {
    latitude = std::atan2(position.z() + kEccentricity2 * curvature(latitude) * std::sin(latitude), across);
  }
  const double sine = std::sin(latitude);
  const double altitude =
      across * std::cos(latitude) + position.z() * sine - kRadius * std::sqrt(1 - kEccentricity2 * sine * sine);
  return {latitude, std::atan2(position.y(), position.x()), altitude};
}

}  // namespace

TangentPlane::TangentPlane(const GeodeticPosition& origin, double heading) : origin_(toEarth(origin)) {
  const double sinLat = std::sin(origin.latitude), cosLat = std::cos(origin.latitude);
  const double sinLon = std::sin(origin.longitude), cosLon = std::cos(origin.longitude);
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
