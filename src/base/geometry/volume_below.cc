#include "base/geometry/volume_below.hh"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pongsim/math.hh"

namespace pongsim::base {

namespace {

constexpr double kPi = std::numbers::pi;

/// The part of a disc about the origin with x up to `limit`.
struct Segment {
  double area = 0;
  /// Integral of the squared distance from the disc's centre.
  double polar = 0;
};

Segment segmentOf(double radius, double limit) {
  const double x = std::clamp(limit, -radius, radius);
  const double square = radius * radius;
  const double y = std::sqrt(std::max(0.0, square - x * x));
  // starting at -radius
  const double angle = radius > 0 ? math::asin(x / radius) + kPi / 2 : 0;
  const double area = square * angle + x * y;
  return {area, (x * (2 * x * x - square) * y + square * square * angle) / 6 + square * area / 3};
}

/// Integral over u of the part of a ball's slice at u that lies in its upper half, where the boundary of that half cuts
/// the slices: |u| at most `radius * sine`. `sine` and `cosine` are of the angle between `up` and z.
double sliceIntegral(double radius, double sine, double cosine, double u) {
  // minus zero would flip the sign
  const double k = (cosine + 0.0) / sine;
  const double stretch = 1 / (sine * sine);
  const double square = radius * radius;
  // zero at the ends, where rounding would leave a small root that the arctangent magnifies for small k
  const double p = std::abs(u) < radius * sine ? std::sqrt(std::max(0.0, square - stretch * u * u)) : 0;
  const double rim = std::sqrt(std::max(0.0, square - u * u));
  // distance of the boundary from the slice's centre, in radii
  double edge = (u < 0) == (k >= 0) ? 1 : -1;
  if (p > 0 && rim > 0) edge = std::clamp(-k * u / rim, -1.0, 1.0);
  return (square * u - u * u * u / 3) * math::acos(edge) + k * p * (square - p * p) / (3 * stretch) +
         2 * square * radius / 3 * math::atan2(p, radius * k);
}

double sliceVolume(double radius, double from, double to) {
  const double square = radius * radius;
  return kPi * (square * (to - from) - (to * to * to - from * from * from) / 3);
}

double halfBallVolume(double radius, double sine, double cosine, double height) {
  const double u = std::clamp(height, -radius, radius);
  const double end = radius * sine;
  double volume = 0;
  if (cosine < 0) volume += sliceVolume(radius, -radius, std::min(u, -end));
  if (u > -end && end > 1e-9 * radius) {
    volume += sliceIntegral(radius, sine, cosine, std::min(u, end)) - sliceIntegral(radius, sine, cosine, -end);
  }
  if (cosine >= 0 && u > end) volume += sliceVolume(radius, end, u);
  return volume;
}

/// Nodes in (0, 1) and weights of Gauss-Legendre quadrature with twelve points symmetric about zero.
constexpr std::array<std::array<double, 2>, 6> kGauss{{{0.1252334085114689, 0.2491470458134028},
                                                       {0.3678314989981802, 0.2334925365383548},
                                                       {0.5873179542866175, 0.2031674267230659},
                                                       {0.7699026741943047, 0.1600783285433462},
                                                       {0.9041172563704749, 0.1069393259953184},
                                                       {0.9815606342467193, 0.0471753363865118}}};

constexpr std::array<std::array<std::uint32_t, 3>, 12> kBoxTriangles{{{0, 2, 1},
                                                                      {1, 2, 3},
                                                                      {4, 5, 6},
                                                                      {5, 7, 6},
                                                                      {0, 1, 4},
                                                                      {1, 5, 4},
                                                                      {2, 6, 3},
                                                                      {3, 6, 7},
                                                                      {0, 4, 2},
                                                                      {2, 4, 6},
                                                                      {1, 3, 5},
                                                                      {3, 7, 5}}};

void addTetrahedron(const Vector3& apex, const Vector3& a, const Vector3& b, const Vector3& c, VolumeMoments& sum) {
  const double volume = (a - apex).dot((b - apex).cross(c - apex)) / 6;
  sum.volume += volume;
  sum.first += volume / 4 * (apex + a + b + c);
}

/// Adds the part below the plane of a triangle that the plane cuts. Corner `a` is alone on its side.
void addCut(const Vector3& apex, const std::array<Vector3, 3>& corner, const std::array<double, 3>& above,
            VolumeMoments& sum) {
  const Vector3 ab = corner[0] + above[0] / (above[0] - above[1]) * (corner[1] - corner[0]);
  const Vector3 ac = corner[0] + above[0] / (above[0] - above[2]) * (corner[2] - corner[0]);
  if (above[0] <= 0) {
    addTetrahedron(apex, corner[0], ab, ac, sum);
  } else {
    addTetrahedron(apex, ab, corner[1], corner[2], sum);
    addTetrahedron(apex, ab, corner[2], ac, sum);
  }
}

}  // namespace

VolumeMoments boxBelow(const Vector3& size, const Vector3& up, double height) {
  std::array<Vector3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector3 sign((i & 1U) != 0 ? 0.5 : -0.5, (i & 2U) != 0 ? 0.5 : -0.5, (i & 4U) != 0 ? 0.5 : -0.5);
    corners[i] = sign.cwiseProduct(size);
  }
  return trianglesBelow(corners, kBoxTriangles, up, height);
}

// The volume is the integral of the slices perpendicular to `up`. The moments follow from Gauss's theorem: the moment
// of p is half the integral of p^2 over the surface. On the round part p^2 is constant, so only the two flat faces
// matter.
VolumeMoments halfBallBelow(double radius, const Vector3& up, double height) {
  const double sine = up.head<2>().norm();
  const double cosine = up.z();
  // all or nothing
  if (height >= radius * (cosine >= 0 ? 1 : sine)) {
    return {2 * kPi / 3 * radius * radius * radius, Vector3(0, 0, kPi / 4 * (radius * radius) * (radius * radius))};
  }
  if (height <= -radius * (cosine >= 0 ? sine : 1)) return {};
  const double u = std::clamp(height, -radius, radius);
  const double rim = std::sqrt(std::max(0.0, radius * radius - u * u));
  const bool isLevel = sine <= 1e-9;
  const double inBase = isLevel ? (u >= 0 ? radius : -radius) : u / sine;
  // if the two faces coincide, count them once
  const bool isCutInside = u * cosine > 0 || (u == 0 && cosine > 0);
  const double inCut = isLevel ? (isCutInside ? rim : -rim) : u * cosine / sine;
  const Segment base = segmentOf(radius, inBase);
  const Segment cut = segmentOf(rim, inCut);
  VolumeMoments part;
  part.volume = halfBallVolume(radius, isLevel ? 0 : sine, cosine, u);
  part.first =
      (radius * radius * base.area - base.polar) / 2 * Vector3::UnitZ() + (cut.polar - rim * rim * cut.area) / 2 * up;
  return part;
}

// Strips along z, as far as the plane allows. With x = r sin(angle) along the plane's slope, the integrand is smooth,
// so Gauss quadrature is exact up to rounding.
VolumeMoments cylinderBelow(double radius, double length, const Vector3& up, double height) {
  const double slope = up.head<2>().norm();
  const double cosine = std::abs(up.z());
  const bool isLevel = slope <= 1e-12;
  const auto endOf = [&](double rise) {
    if (isLevel) return rise >= 0 ? radius : -radius;
    return std::clamp(rise / slope, -radius, radius);
  };
  // strips are complete up to `full`; there are none beyond `none`
  const double full = isLevel ? -radius : endOf(height - cosine * length / 2);
  const double none = isLevel ? radius : endOf(height + cosine * length / 2);
  const double square = radius * radius;
  double volume = length * segmentOf(radius, full).area;
  const double left = std::max(0.0, square - full * full);
  double alongSlope = -length * 2 / 3 * left * std::sqrt(left);
  double alongAxis = 0;
  if (cosine > 1e-12 && none > full) {
    const double first = math::asin(full / radius), last = math::asin(none / radius);
    const double middle = (first + last) / 2, half = (last - first) / 2;
    for (const auto& [node, weight] : kGauss) {
      for (const double angle : {middle - half * node, middle + half * node}) {
        const double x = radius * math::sin(angle);
        const double width = 2 * square * math::cos(angle) * math::cos(angle) * weight * half;
        const double strip = std::clamp((height - slope * x) / cosine + length / 2, 0.0, length);
        volume += width * strip;
        alongSlope += width * strip * x;
        alongAxis += width * strip * (strip - length) / 2;
      }
    }
  }
  VolumeMoments part{volume, Vector3(0, 0, up.z() < 0 ? -alongAxis : alongAxis)};
  if (!isLevel) part.first.head<2>() = alongSlope / slope * up.head<2>();
  return part;
}

// Tetrahedra from a point in the plane to the parts of the triangles below it; those to the cut itself are flat.
VolumeMoments trianglesBelow(std::span<const Vector3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles,
                             const Vector3& up, double height) {
  const Vector3 apex = height * up;
  VolumeMoments sum;
  for (const auto& triangle : triangles) {
    const std::array<Vector3, 3> corner{vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]]};
    const std::array<double, 3> above{up.dot(corner[0]) - height, up.dot(corner[1]) - height,
                                      up.dot(corner[2]) - height};
    const std::array<bool, 3> isBelow{above[0] <= 0, above[1] <= 0, above[2] <= 0};
    if (isBelow[0] == isBelow[1] && isBelow[1] == isBelow[2]) {
      if (isBelow[0]) addTetrahedron(apex, corner[0], corner[1], corner[2], sum);
      continue;
    }
    const std::size_t lone = isBelow[1] == isBelow[2] ? 0 : isBelow[0] == isBelow[2] ? 1 : 2;
    const std::size_t next = (lone + 1) % 3, last = (lone + 2) % 3;
    addCut(apex, {corner[lone], corner[next], corner[last]}, {above[lone], above[next], above[last]}, sum);
  }
  return sum;
}

}  // namespace pongsim::base
