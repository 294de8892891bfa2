#include "sdf/readers/models/mass_properties.hh"

#include <cmath>
#include <numbers>
#include <variant>

namespace pongsim::sdf {

namespace {

using std::numbers::pi;

/// @return The inertia tensor about the origin of a point mass there.
Matrix3 pointMoments(double mass, const Vector3& place) {
  return mass * (place.squaredNorm() * Matrix3::Identity() - place * place.transpose());
}

/// @param moments Principal moments about the centre of mass, per mass [m^2].
/// @param center Centre of mass on z [m].
MassProperties onAxis(double mass, const Vector3& moments, double center = 0) {
  const Vector3 place(0, 0, center);
  return {mass, mass * place, mass * Matrix3(moments.asDiagonal()) + pointMoments(mass, place)};
}

/// Signed volume integrals over the tetrahedra between the origin and each triangle: with its corners a, b, c and
/// s = a + b + c, the integral of x x^T is a . (b x c) / 120 (s s^T + a a^T + b b^T + c c^T).
/// F. Tonon, Explicit exact formulas for the 3-D tetrahedron inertia tensor in terms of its vertex coordinates, Journal
/// of Mathematics and Statistics 1, 2005.
std::optional<MassProperties> ofTriangles(const description::TriangleMesh* mesh, const Vector3& scale, double density) {
  if (mesh == nullptr || mesh->triangles.empty()) return std::nullopt;
  // from the mesh's own middle, so that little cancels where it lies far from the origin
  Vector3 middle = Vector3::Zero();
  for (const Vector3& vertex : mesh->vertices) middle += vertex / static_cast<double>(mesh->vertices.size());
  const auto corner = [&](std::uint32_t i) -> Vector3 { return scale.cwiseProduct(mesh->vertices[i] - middle); };

  double volume = 0;
  Vector3 first = Vector3::Zero();
  Matrix3 second = Matrix3::Zero();
  for (const auto& triangle : mesh->triangles) {
    const Vector3 a = corner(triangle[0]), b = corner(triangle[1]), c = corner(triangle[2]), sum = a + b + c;
    const double part = a.dot(b.cross(c));
    volume += part / 6;
    first += part / 24 * sum;
    second += part / 120 * (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
  }
  // negative where the triangles, or the scale, turn the mesh inside out
  const double sign = volume < 0 ? -density : density;
  const Matrix3 moments = second.trace() * Matrix3::Identity() - second;
  const MassProperties aroundMiddle{sign * volume, sign * first, sign * moments};
  return aroundMiddle.in({scale.cwiseProduct(middle), Quaternion::Identity()});
}

// Moments of inertia of homogeneous solids: the usual tables, such as H. Goldstein, Classical Mechanics.
struct PropertiesOf {
  using Result = std::optional<MassProperties>;
  double density;

  Result operator()(const description::Box& box) const {
    const Vector3 squares = box.size.cwiseProduct(box.size);
    return onAxis(density * box.size.prod(), (Vector3::Constant(squares.sum()) - squares) / 12);
  }
  Result operator()(const description::Sphere& sphere) const {
    const double square = sphere.radius * sphere.radius;
    return onAxis(density * 4 / 3 * pi * square * sphere.radius, Vector3::Constant(0.4 * square));
  }
  Result operator()(const description::Ellipsoid& ellipsoid) const {
    const Vector3 squares = ellipsoid.radii.cwiseProduct(ellipsoid.radii);
    return onAxis(density * 4 / 3 * pi * ellipsoid.radii.prod(), (Vector3::Constant(squares.sum()) - squares) / 5);
  }
  Result operator()(const description::Cylinder& cylinder) const {
    const double square = cylinder.radius * cylinder.radius;
    const double across = square / 4 + cylinder.length * cylinder.length / 12;
    return onAxis(density * pi * square * cylinder.length, {across, across, square / 2});
  }
  Result operator()(const description::Capsule& capsule) const {
    Result sum = (*this)(description::Cylinder{capsule.radius, capsule.length});
    const double square = capsule.radius * capsule.radius;
    // half a ball: its centre of mass is 3/8 of the radius from its flat side
    const double mass = density * 2 / 3 * pi * square * capsule.radius, depth = 0.375 * capsule.radius;
    const double across = 0.4 * square - depth * depth;
    for (const double side : {-1.0, 1.0}) {
      *sum += onAxis(mass, {across, across, 0.4 * square}, side * (capsule.length / 2 + depth));
    }
    return sum;
  }
  Result operator()(const description::Cone& cone) const {
    const double square = cone.radius * cone.radius;
    const double across = 3.0 / 80 * (4 * square + cone.length * cone.length);
    return onAxis(density * pi / 3 * square * cone.length, {across, across, 0.3 * square}, -cone.length / 4);
  }
  Result operator()(const description::Mesh& mesh) const {
    return ofTriangles(mesh.triangles.get(), mesh.scale, density);
  }
  Result operator()(const description::Polyline& line) const {
    return ofTriangles(line.triangles.get(), {1, 1, 1}, density);
  }
  Result operator()(const description::Plane&) const { return std::nullopt; }
  Result operator()(const description::Heightmap&) const { return std::nullopt; }
  Result operator()(const description::Image&) const { return std::nullopt; }
  Result operator()(const description::Empty&) const { return std::nullopt; }
};

}  // namespace

MassProperties& MassProperties::operator+=(const MassProperties& other) {
  mass += other.mass;
  first += other.first;
  moments += other.moments;
  return *this;
}

MassProperties MassProperties::in(const Pose& X_AB) const {
  if (mass == 0) return *this;
  const Matrix3 R_AB = X_AB.rotation.toRotationMatrix();
  const Vector3 center = first / mass, moved = X_AB * center;
  // the parallel axis theorem, to the centre of mass and back
  const Matrix3 central = moments - pointMoments(mass, center);
  return {mass, mass * moved, R_AB * central * R_AB.transpose() + pointMoments(mass, moved)};
}

description::Inertial MassProperties::inertial(double scaledMass) const {
  const Vector3 center = first / mass;
  const Matrix3 central = scaledMass / mass * (moments - pointMoments(mass, center));
  return {scaledMass, {center, Quaternion::Identity()}, (central + central.transpose()) / 2};
}

std::optional<MassProperties> massPropertiesOf(const description::Geometry& geometry, double density) {
  return std::visit(PropertiesOf{density}, geometry);
}

}  // namespace pongsim::sdf
