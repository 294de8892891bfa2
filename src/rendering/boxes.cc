#include "rendering/boxes.hh"

#include <algorithm>
#include <cassert>
#include <vector>

#include <Eigen/Eigenvalues>

namespace pongsim::rendering {

namespace {

using Eigen::AlignedBox2d;
using Eigen::AlignedBox3d;

/// @return Where a position in the camera's frame is seen, from the left and the top [pixels].
Eigen::Vector2d pixelOf(const Vector3& place, const PictureView& view) {
  return {view.cx - (view.fx * place.y() + view.skew * place.z()) / place.x(),
          view.cy - view.fy * place.z() / place.x()};
}

/// @return The vertices of an item in another frame.
/// @param X_FrameSurface Pose of its surface in that frame.
std::vector<Vector3> verticesOf(const Item& item, const Pose& X_FrameSurface) {
  std::vector<Vector3> places;
  places.reserve(item.surface->vertices.size());
  for (const Vertex& vertex : item.surface->vertices) {
    places.push_back(X_FrameSurface * Vector3(item.scale.cwiseProduct(vertex.position.cast<double>())));
  }
  return places;
}

void addBounds(const Item& item, const PictureView& view, AlignedBox2d& bounds) {
  const std::vector<Vector3> places = verticesOf(item, view.X_WorldEye.inverse() * item.X_WorldSurface());
  for (const Vector3& place : places) {
    if (place.x() >= view.near) bounds.extend(pixelOf(place, view));
  }
  // where edges pass the near clip plane
  const std::vector<std::uint32_t>& corners = item.surface->corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    const Vector3 &from = places[corners[i]], &to = places[corners[next]];
    if ((from.x() < view.near) == (to.x() < view.near)) continue;
    const double share = (view.near - from.x()) / (to.x() - from.x());
    Vector3 place = from + share * (to - from);
    place.x() = view.near;
    bounds.extend(pixelOf(place, view));
  }
}

/// @return The axes in which positions vary least, in between and most.
Matrix3 principalAxes(const std::vector<Vector3>& places) {
  Vector3 mean = Vector3::Zero();
  for (const Vector3& place : places) mean += place / static_cast<double>(places.size());
  Matrix3 covariance = Matrix3::Zero();
  for (const Vector3& place : places) covariance += (place - mean) * (place - mean).transpose();
  Matrix3 axes = Eigen::SelfAdjointEigenSolver<Matrix3>(covariance).eigenvectors();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

}  // namespace

AlignedBox2d imageBounds(const Scene& scene, std::size_t visual, const PictureView& view) {
  AlignedBox2d bounds;
  for (const Item& item : scene.items()) {
    if (item.number == visual) addBounds(item, view, bounds);
  }
  return bounds;
}

TurnedBox turnedBox(const Scene& scene, std::span<const std::size_t> visuals) {
  assert(!visuals.empty());
  const auto isMeant = [&](const Item& item) { return std::ranges::find(visuals, item.number) != visuals.end(); };
  if (visuals.size() == 1) {
    // the parts of a mesh have the same frame
    AlignedBox3d box;
    Pose X_WorldSurface;
    for (const Item& item : scene.items()) {
      if (!isMeant(item)) continue;
      X_WorldSurface = item.X_WorldSurface();
      for (const Vector3& corner : {item.bounds.min(), item.bounds.max()}) box.extend(item.scale.cwiseProduct(corner));
    }
    if (box.isEmpty()) return {};
    return {{X_WorldSurface * box.center(), X_WorldSurface.rotation}, box.sizes()};
  }
  std::vector<Vector3> places;
  for (const Item& item : scene.items()) {
    if (!isMeant(item)) continue;
    for (const Vector3& place : verticesOf(item, item.X_WorldSurface())) places.push_back(place);
  }
  if (places.empty()) return {};
  const Matrix3 axes = principalAxes(places);
  AlignedBox3d box;
  for (const Vector3& place : places) box.extend(axes.transpose() * place);
  return {{axes * box.center(), Quaternion(axes)}, box.sizes()};
}

}  // namespace pongsim::rendering
