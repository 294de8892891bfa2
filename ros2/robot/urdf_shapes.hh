#pragma once

#include <ignition/msgs/geometry.pb.h>
#include <ignition/msgs/material.pb.h>

#include <string>
#include <string_view>
#include <vector>

#include "pongsim/handles.hh"
#include "ros2/robot/xml_writer.hh"

namespace pongsim::ros2 {

/// What URDF can say of a shape: one of its own shapes, or several that together are it.
struct UrdfShape {
  enum class Kind { kBox, kSphere, kCylinder, kMesh };
  Kind kind = Kind::kBox;
  /// Of this shape in the frame of the whole.
  Pose X_ShapePart = {};
  /// Of a box: full lengths [m]; of a mesh: its scale.
  Vector3 size = Vector3::Ones();
  /// [m]
  double radius = 0;
  double length = 0;
  /// Of a mesh: its address, "file:///...".
  std::string address = {};
};

/// @param warning Set where it is not quite the shape, or nothing: "is an ellipsoid: ...".
std::vector<UrdfShape> urdfShapesOf(const ignition::msgs::Geometry& geometry, std::string& warning);
std::vector<UrdfShape> urdfShapesOf(const Collision& collision, std::string& warning);

/// Writes a `<geometry>`.
void writeShape(const UrdfShape& shape, XmlWriter& xml);

/// @return "file:///home/me/a%20mesh.dae"
std::string fileAddress(std::string_view path);

}  // namespace pongsim::ros2
