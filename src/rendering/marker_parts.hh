#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "rendering/surface.hh"
#include "world/markers.hh"

namespace pongsim::rendering {

/// What of a marker is drawn at once, in one colour and without light.
struct MarkerPart {
  enum class Kind { kTriangles, kLines, kPoints };
  Kind kind = Kind::kTriangles;
  /// Its corners are those of triangles, the ends of lines, or points.
  std::shared_ptr<const Surface> surface;
  /// In the frame of the marker, before it is scaled.
  Eigen::Affine3d X_MarkerPart = Eigen::Affine3d::Identity();
  /// Instead of the marker's.
  std::optional<Eigen::Vector3f> color = std::nullopt;
  /// Whether it turns towards whoever looks: x points away from the eye, z upwards in the picture.
  bool facesEye = false;
};

/// Makes the parts of markers. Simple shapes have the size 1 along each axis, as in Fortress: a sphere has the radius
/// 0.5. Lines and points are one pixel wide.
class MarkerParts {
 public:
  std::vector<MarkerPart> of(const world::Marker& marker);

 private:
  std::shared_ptr<const Surface> shape(world::Marker::Type type);
  void addArrow(const Eigen::Quaterniond& rotation, const std::optional<Eigen::Vector3f>& color,
                std::vector<MarkerPart>& parts);

  /// Made when first needed, and shared by all markers of the type.
  std::map<world::Marker::Type, std::shared_ptr<const Surface>> shapes_;
};

}  // namespace pongsim::rendering
