#pragma once

#include <ignition/msgs/geometry.pb.h>
#include <ignition/msgs/material.pb.h>

#include <string>
#include <string_view>
#include <vector>

#include "pongsim/handles.hh"
#include "ros2/robot/xml_writer.hh"

namespace pongsim::ros2 {

/// A shape that URDF can express: one of its own shapes, or one of several that together form the original.
struct UrdfShape {
  enum class Kind { kBox, kSphere, kCylinder, kMesh };
  Kind kind = Kind::kBox;
  /// Pose of this part in the frame of the whole shape.
  Pose X_ShapePart = {};
  /// For boxes: full side lengths [m]; for meshes: the scale.
  Vector3 size = Vector3::Ones();
  /// [m]
  double radius = 0;
  double length = 0;
  /// For meshes: the address, "file:///...".
  std::string address = {};
};

/// @param warning Set if the result is only similar to the shape, or empty: "is an ellipsoid: ...".
std::vector<UrdfShape> urdfShapesOf(const ignition::msgs::Geometry& geometry, std::string& warning);
std::vector<UrdfShape> urdfShapesOf(const Collision& collision, std::string& warning);

/// Writes a `<geometry>`.
void writeShape(const UrdfShape& shape, XmlWriter& xml);

/// @return "file:///home/me/a%20mesh.dae"
std::string fileAddress(std::string_view path);

}  // namespace pongsim::ros2
