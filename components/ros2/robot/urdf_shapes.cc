#include "ros2/robot/urdf_shapes.hh"

#include <algorithm>
#include <variant>

#include "pongsim/geometry/rotation_between.hh"

namespace pongsim::ros2 {

namespace {

/// Thickness of the box that displays a plane [m].
constexpr double kSheet = 1e-3;

UrdfShape boxOf(const Vector3& size) { return {.kind = UrdfShape::Kind::kBox, .size = size}; }
UrdfShape sphereOf(double radius, const Pose& pose = {}) {
  return {.kind = UrdfShape::Kind::kSphere, .X_ShapePart = pose, .radius = radius};
}
UrdfShape cylinderOf(double radius, double length) {
  return {.kind = UrdfShape::Kind::kCylinder, .radius = radius, .length = length};
}

std::vector<UrdfShape> capsuleOf(double radius, double length) {
  return {cylinderOf(radius, length), sphereOf(radius, {Vector3(0, 0, length / 2), Quaternion::Identity()}),
          sphereOf(radius, {Vector3(0, 0, -length / 2), Quaternion::Identity()})};
}

std::vector<UrdfShape> ellipsoidOf(const Vector3& radii, std::string& warning) {
  const bool isBall = radii.x() == radii.y() && radii.y() == radii.z();
  if (!isBall) warning = "is an ellipsoid, which URDF does not have: a sphere around it is used";
  return {sphereOf(radii.maxCoeff())};
}

std::vector<UrdfShape> meshOf(const std::string& file, const std::string& submesh, const Vector3& scale,
                              std::string& warning) {
  if (!file.starts_with('/')) {
    warning = "is a mesh whose file was not found: it is left out";
    return {};
  }
  if (!submesh.empty()) {
    warning = "is the part '" + submesh + "' of a mesh, but URDF uses whole files: all of '" + file + "' is there";
  }
  return {{.kind = UrdfShape::Kind::kMesh, .size = scale, .address = fileAddress(file)}};
}

Vector3 asVector(const ignition::msgs::Vector3d& vector) { return {vector.x(), vector.y(), vector.z()}; }

struct ShapesOf {
  const std::optional<MeshFile>& mesh;
  std::string& warning;

  std::vector<UrdfShape> operator()(const NoShape&) const {
    if (mesh) warning = "is a mesh that could not be read: it is left out";
    return {};
  }
  std::vector<UrdfShape> operator()(const BoxShape& box) const { return {boxOf(box.size)}; }
  std::vector<UrdfShape> operator()(const SphereShape& sphere) const { return {sphereOf(sphere.radius)}; }
  std::vector<UrdfShape> operator()(const CylinderShape& shape) const {
    return {cylinderOf(shape.radius, shape.length)};
  }
  std::vector<UrdfShape> operator()(const CapsuleShape& shape) const { return capsuleOf(shape.radius, shape.length); }
  std::vector<UrdfShape> operator()(const EllipsoidShape& shape) const { return ellipsoidOf(shape.radii, warning); }
  std::vector<UrdfShape> operator()(const PlaneShape&) const {
    warning = "is an infinite plane, which URDF does not have: it is left out";
    return {};
  }
  std::vector<UrdfShape> operator()(const TriangleShape&) const {
    if (mesh) return meshOf(mesh->file.string(), mesh->submesh, mesh->scale, warning);
    warning = "is a cone, a polyline or a heightmap, which URDF does not have: it is left out";
    return {};
  }
};

}  // namespace

std::vector<UrdfShape> urdfShapesOf(const ignition::msgs::Geometry& geometry, std::string& warning) {
  using Kind = ignition::msgs::Geometry;
  warning.clear();
  switch (geometry.type()) {
    case Kind::BOX:
      return {boxOf(asVector(geometry.box().size()))};
    case Kind::SPHERE:
      return {sphereOf(geometry.sphere().radius())};
    case Kind::CYLINDER:
      return {cylinderOf(geometry.cylinder().radius(), geometry.cylinder().length())};
    case Kind::CAPSULE:
      return capsuleOf(geometry.capsule().radius(), geometry.capsule().length());
    case Kind::CONE:
      warning = "is a cone, which URDF does not have: a cylinder around it is used";
      return {cylinderOf(geometry.cone().radius(), geometry.cone().length())};
    case Kind::ELLIPSOID:
      return ellipsoidOf(asVector(geometry.ellipsoid().radii()), warning);
    case Kind::PLANE: {
      UrdfShape sheet = boxOf({geometry.plane().size().x(), geometry.plane().size().y(), kSheet});
      sheet.X_ShapePart.rotation = rotationBetween(Vector3::UnitZ(), asVector(geometry.plane().normal()).normalized());
      return {sheet};
    }
    case Kind::MESH:
      return meshOf(geometry.mesh().filename(), geometry.mesh().submesh(), asVector(geometry.mesh().scale()), warning);
    case Kind::EMPTY:
      return {};
    default:
      warning = "is a " + std::string(geometry.type() == Kind::HEIGHTMAP ? "heightmap" : "polyline or an image") +
                ", which URDF does not have: it is left out";
      return {};
  }
}

std::vector<UrdfShape> urdfShapesOf(const Collision& collision, std::string& warning) {
  warning.clear();
  const std::optional<MeshFile> mesh = collision.meshFile();
  return std::visit(ShapesOf{mesh, warning}, collision.shape());
}

void writeShape(const UrdfShape& shape, XmlWriter& xml) {
  xml.open("geometry");
  switch (shape.kind) {
    case UrdfShape::Kind::kBox:
      xml.open("box").with("size", shape.size);
      break;
    case UrdfShape::Kind::kSphere:
      xml.open("sphere").with("radius", shape.radius);
      break;
    case UrdfShape::Kind::kCylinder:
      xml.open("cylinder").with("radius", shape.radius).with("length", shape.length);
      break;
    case UrdfShape::Kind::kMesh:
      xml.open("mesh").with("filename", shape.address).with("scale", shape.size);
      break;
  }
  xml.close().close();
}

std::string fileAddress(std::string_view path) {
  constexpr std::string_view kPlain = "/-._~!$&'()*+,;=:@";
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string address = "file://";
  for (const char letter : path) {
    const auto code = static_cast<unsigned char>(letter);
    const bool isPlain = (letter >= '0' && letter <= '9') || (letter >= 'A' && letter <= 'Z') ||
                         (letter >= 'a' && letter <= 'z') || kPlain.find(letter) != std::string_view::npos;
    if (isPlain) {
      address += letter;
    } else {
      address.append({'%', kDigits[code >> 4U], kDigits[code & 15U]});
    }
  }
  return address;
}

}  // namespace pongsim::ros2
