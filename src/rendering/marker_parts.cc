#include "rendering/marker_parts.hh"

#include <cstdint>
#include <numbers>
#include <string>

#include "rendering/small_font.hh"

namespace pongsim::rendering {

namespace {

using MarkerType = world::Marker::Type;

Surface unitShape(MarkerType type) {
  switch (type) {
    case MarkerType::kBox:
      return boxSurface();
    case MarkerType::kCylinder:
      return cylinderSurface();
    case MarkerType::kCone:
      return coneSurface();
    case MarkerType::kCapsule:
      return capsuleSurface({0.5, 1});
    default:
      return sphereSurface();
  }
}

/// @return How a shape of `unitShape` becomes one of the size 1.
Eigen::Affine3d unitScale(MarkerType type) {
  Vector3 scale = Vector3::Ones();
  if (type == MarkerType::kCylinder || type == MarkerType::kCone) scale = {0.5, 0.5, 1};
  if (type == MarkerType::kSphere || type == MarkerType::kEllipsoid) scale.setConstant(0.5);
  return Eigen::Affine3d(Eigen::Scaling(scale));
}

MarkerPart::Kind partKind(MarkerType type) {
  if (type == MarkerType::kPoints) return MarkerPart::Kind::kPoints;
  const bool isLine = type == MarkerType::kLineList || type == MarkerType::kLineStrip;
  return isLine ? MarkerPart::Kind::kLines : MarkerPart::Kind::kTriangles;
}

/// Adds the corners of lists, strips and fans of `count` points. What is left over at the end is not drawn.
void addCorners(MarkerType type, std::uint32_t count, std::vector<std::uint32_t>& corners) {
  const auto add = [&corners](std::initializer_list<std::uint32_t> more) { corners.insert(corners.end(), more); };
  switch (type) {
    case MarkerType::kLineList:
      for (std::uint32_t i = 0; i + 1 < count; i += 2) add({i, i + 1});
      break;
    case MarkerType::kLineStrip:
      for (std::uint32_t i = 0; i + 1 < count; ++i) add({i, i + 1});
      break;
    case MarkerType::kTriangleList:
      for (std::uint32_t i = 0; i + 2 < count; i += 3) add({i, i + 1, i + 2});
      break;
    case MarkerType::kTriangleStrip:
      for (std::uint32_t i = 0; i + 2 < count; ++i) add({i, i + 1, i + 2});
      break;
    case MarkerType::kTriangleFan:
      for (std::uint32_t i = 1; i + 1 < count; ++i) add({0, i, i + 1});
      break;
    default:
      for (std::uint32_t i = 0; i < count; ++i) add({i});
  }
}

Surface pointSurface(MarkerType type, const std::vector<Vector3>& points) {
  Surface surface;
  for (const Vector3& point : points) surface.vertices.push_back({point.cast<float>(), Eigen::Vector3f::UnitZ()});
  addCorners(type, static_cast<std::uint32_t>(points.size()), surface.corners);
  return surface;
}

/// Size of a dot of a letter that is 1 high.
constexpr double kTextDot = 1.0 / kLetterHeight;

/// Letters of dots, upright in the plane of y and z, centred on x. A letter is 1 high.
Surface textSurface(const std::string& text) {
  const std::string letters = lettersOf(text);
  const double across = (static_cast<double>(letters.size()) * kLetterAdvance - 1) * kTextDot;
  Surface surface;
  const auto addDot = [&surface](double left, double top) {
    const auto first = static_cast<std::uint32_t>(surface.vertices.size());
    for (const auto& [right, down] : {std::pair(0.0, 0.0), {0.0, kTextDot}, {kTextDot, kTextDot}, {kTextDot, 0.0}}) {
      const Vector3 corner(0, -(left + right), top - down);
      surface.vertices.push_back({corner.cast<float>(), Eigen::Vector3f::UnitX()});
    }
    for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) surface.corners.push_back(first + corner);
  };
  for (std::size_t i = 0; i < letters.size(); ++i) {
    const SmallLetter letter = smallLetter(static_cast<unsigned char>(letters[i]));
    for (std::size_t column = 0; column < kLetterWidth; ++column) {
      for (std::size_t row = 0; row < kLetterHeight; ++row) {
        if ((letter[column] >> row & 1U) == 0) continue;
        addDot(static_cast<double>(i * kLetterAdvance + column) * kTextDot - across / 2,
               0.5 - static_cast<double>(row) * kTextDot);
      }
    }
  }
  return surface;
}

}  // namespace

std::vector<MarkerPart> MarkerParts::of(const world::Marker& marker) {
  std::vector<MarkerPart> parts;
  const MarkerType type = marker.type;
  switch (type) {
    case MarkerType::kNone:
      break;
    case MarkerType::kBox:
    case MarkerType::kCylinder:
    case MarkerType::kSphere:
    case MarkerType::kCone:
    case MarkerType::kCapsule:
    case MarkerType::kEllipsoid:
      parts.push_back({.surface = shape(type), .X_MarkerPart = unitScale(type)});
      break;
    case MarkerType::kText:
      parts.push_back({.surface = std::make_shared<const Surface>(textSurface(marker.text)), .facesEye = true});
      break;
    case MarkerType::kArrow:
      addArrow(Quaternion::Identity(), std::nullopt, parts);
      break;
    case MarkerType::kAxis:
      for (int axis = 0; axis < 3; ++axis) {
        const Vector3 along = Vector3::Unit(axis);
        addArrow(Quaternion::FromTwoVectors(Vector3::UnitZ(), along), Eigen::Vector3f(along.cast<float>()), parts);
      }
      break;
    default:
      parts.push_back(
          {.kind = partKind(type), .surface = std::make_shared<const Surface>(pointSurface(type, marker.points))});
  }
  return parts;
}

std::shared_ptr<const Surface> MarkerParts::shape(MarkerType type) {
  std::shared_ptr<const Surface>& known = shapes_[type];
  if (known == nullptr) known = std::make_shared<const Surface>(unitShape(type));
  return known;
}

/// Along z, with the measures of Fortress's arrow: a shaft 0.5 long and 0.05 thick, and a head 0.25 long and 0.1 thick.
void MarkerParts::addArrow(const Eigen::Quaterniond& rotation, const std::optional<Eigen::Vector3f>& color,
                           std::vector<MarkerPart>& parts) {
  const auto add = [&](MarkerType type, double middle, double thickness, double length) {
    Eigen::Affine3d place(rotation);
    place = place * Eigen::Translation3d(0, 0, middle) * Eigen::Scaling(thickness, thickness, length) * unitScale(type);
    parts.push_back({.surface = shape(type), .X_MarkerPart = place, .color = color});
  };
  add(MarkerType::kCylinder, 0.25, 0.05, 0.5);
  add(MarkerType::kCone, 0.625, 0.1, 0.25);
}

}  // namespace pongsim::rendering
