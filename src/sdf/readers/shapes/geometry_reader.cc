#include "sdf/readers/shapes/geometry_reader.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "sdf/includes/asset_file.hh"
#include "sdf/readers/shapes/heightmap_reader.hh"
#include "sdf/readers/shapes/mesh_reader.hh"
#include "sdf/readers/shapes/polyline_reader.hh"
#include "sdf/schema/schema.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

/// Three positive lengths.
Vector3 readLengths(const Element& shape, std::string_view child, const Vector3& fallback, Context& context) {
  const Vector3 lengths = readVector(shape, child, fallback, context);
  if (lengths.minCoeff() > 0) return lengths;
  const Element& element = *shape.child(child);
  context.diagnostics.error(element.position, "<" + element.name + "> is '" + element.text +
                                                  "', which is not three finite numbers above zero");
  return fallback;
}

description::Plane readPlane(const Element& shape, const std::string& owner, Context& context) {
  description::Plane plane;
  const Vector3 normal = readVector(shape, "normal", plane.normal, context);
  const double norm = normal.stableNorm();
  if (norm > 0 && std::isfinite(norm)) {
    plane.normal = (normal / norm).normalized();
  } else {
    context.diagnostics.error(shape.child("normal")->position,
                              "the plane of " + owner + " has a normal of length zero");
  }
  plane.size = readVector2(shape, "size", plane.size, context);
  return plane;
}

description::Image readImage(const Element& shape, const std::string& owner, bool isCollision, Context& context) {
  using Limits = std::numeric_limits<int>;
  description::Image image;
  AssetFile asset = findAsset(shape, "image", owner, isCollision, context);
  image.uri = std::move(asset.uri);
  image.file = std::move(asset.path);
  image.scale = readPositive(shape, "scale", image.scale, context);
  image.threshold = readInteger(shape, "threshold", image.threshold, 0, 255, context);
  image.height = readPositive(shape, "height", image.height, context);
  image.granularity = readInteger(shape, "granularity", image.granularity, 0, Limits::max(), context);
  return image;
}

/// @param geometry The parent of the shape.
description::Geometry readShape(const Element& geometry, const Element& shape, const std::string& owner,
                                bool isCollision, Context& context) {
  if (shape.name == "empty") return description::Empty{};
  if (shape.name == "box") return description::Box{readLengths(shape, "size", {1, 1, 1}, context)};
  if (shape.name == "sphere") return description::Sphere{readPositive(shape, "radius", 1, context)};
  if (shape.name == "cylinder") {
    return description::Cylinder{readPositive(shape, "radius", 1, context), readPositive(shape, "length", 1, context)};
  }
  if (shape.name == "cone") {
    return description::Cone{readPositive(shape, "radius", 1, context), readPositive(shape, "length", 1, context)};
  }
  if (shape.name == "capsule") {
    return description::Capsule{readPositive(shape, "radius", 0.5, context), readPositive(shape, "length", 1, context)};
  }
  if (shape.name == "ellipsoid") return description::Ellipsoid{readLengths(shape, "radii", {1, 1, 1}, context)};
  if (shape.name == "plane") return readPlane(shape, owner, context);
  if (shape.name == "mesh") return readMesh(shape, owner, isCollision, context);
  if (shape.name == "heightmap") return readHeightmap(shape, owner, isCollision, context);
  if (shape.name == "polyline") return readPolylines(geometry, owner, isCollision, context);
  return readImage(shape, owner, isCollision, context);
}

/// @return Whether the format has a shape with this name.
bool isShape(std::string_view name) {
  static const Schema::ElementType& kGeometry = *Schema::instance().shared("geometry")->type;
  return Schema::find(kGeometry.children, name) != nullptr;
}

}  // namespace

description::Geometry readGeometry(const Element& element, const std::string& owner, Context& context) {
  const Element* geometry = element.child("geometry");
  const auto isShapeElement = [](const Element& child) { return isShape(child.name); };
  const auto shape =
      geometry != nullptr ? std::ranges::find_if(geometry->children, isShapeElement) : element.children.end();
  if (geometry == nullptr || shape == geometry->children.end()) {
    const std::string effect = element.name == "collision" ? ": it will not collide" : ": it will not be seen";
    context.diagnostics.warning(
        geometry != nullptr ? geometry->position : element.position,
        owner + " has no " + (geometry != nullptr ? "shape in its <geometry>" : "<geometry>") + effect,
        "add <box>, <sphere>, <cylinder>, <plane>, ...");
    return description::Empty{};
  }
  return readShape(*geometry, *shape, owner, element.name == "collision", context);
}

}  // namespace pongsim::sdf
