#include "msgs/scene/geometry_message.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/geometry.pb.h>

#include <string>
#include <utility>
#include <vector>

#include "pongsim/message.hh"

namespace pongsim::msgs {
namespace {

std::string textOf(const description::Geometry& geometry) {
  ignition::msgs::Geometry message;
  setGeometry(geometry, message);
  // line ends make no difference
  std::string text = messageText(message);
  for (char& letter : text) {
    if (letter == '\n') letter = ' ';
  }
  std::string single;
  for (const char letter : text) {
    if (letter != ' ' || (!single.empty() && single.back() != ' ')) single += letter;
  }
  return single;
}

TEST(GeometryMessage, TellsEveryShape) {
  description::Mesh mesh;
  mesh.uri = "model://cup/cup.dae";
  mesh.submesh = "handle";
  description::Heightmap hills;
  hills.uri = "hills.png";
  hills.file = "/maps/hills.png";
  hills.size = {10, 20, 3};
  hills.blends = {{.minHeight = 2, .fadeDistance = 1}};
  description::Polyline triangle;
  triangle.lines = {{{0, 0}, {1, 0}, {0, 2}}};
  const std::vector<std::pair<description::Geometry, std::string>> cases = {
      {description::Empty{}, "type: EMPTY "},
      {description::Box{{1, 2, 3}}, "box { size { x: 1 y: 2 z: 3 } } "},
      {description::Sphere{0.5}, "type: SPHERE sphere { radius: 0.5 } "},
      {description::Cylinder{0.5, 2}, "type: CYLINDER cylinder { radius: 0.5 length: 2 } "},
      {description::Capsule{0.5, 2}, "type: CAPSULE capsule { radius: 0.5 length: 2 } "},
      {description::Cone{0.5, 2}, "type: CONE cone { radius: 0.5 length: 2 } "},
      {description::Ellipsoid{{1, 2, 3}}, "type: ELLIPSOID ellipsoid { radii { x: 1 y: 2 z: 3 } } "},
      {description::Plane{{0, 0, 1}, {5, 6}}, "type: PLANE plane { normal { z: 1 } size { x: 5 y: 6 } } "},
      {mesh, "type: MESH mesh { filename: \"model://cup/cup.dae\" scale { x: 1 y: 1 z: 1 } submesh: \"handle\" } "},
      {hills,
       "type: HEIGHTMAP heightmap { size { x: 10 y: 20 z: 3 } origin { } blend { min_height: 2 fade_dist: 1 } "
       "filename: \"/maps/hills.png\" sampling: 1 } "},
      {triangle, "type: POLYLINE polyline { height: 1 point { } point { x: 1 } point { y: 2 } } "},
      {description::Image{"a.png", {}, 1, 200, 2, 1},
       "type: IMAGE image { uri: \"a.png\" scale: 1 threshold: 200 height: 2 granularity: 1 } "},
  };
  for (const auto& [geometry, text] : cases) EXPECT_EQ(textOf(geometry), text);
}

TEST(GeometryMessage, MakesEveryShapeAgain) {
  description::Mesh mesh;
  mesh.uri = "model://cup/cup.dae";
  mesh.submesh = "handle";
  mesh.isCentered = true;
  mesh.scale = {1, 2, -3};
  description::Heightmap hills;
  hills.uri = "hills.png";
  hills.size = {10, 20, 3};
  hills.position = {1, 2, 3};
  hills.textures = {{5, {"grass.png", {}}, {"normals.png", {}}}};
  hills.blends = {{.minHeight = 2, .fadeDistance = 1}};
  description::Polyline triangle;
  triangle.lines = {{{0, 0}, {1, 0}, {0, 2}}};
  triangle.height = 2;
  for (const description::Geometry& geometry :
       {description::Geometry(description::Empty{}), description::Geometry(description::Box{{1, 2, 3}}),
        description::Geometry(description::Sphere{0.5}), description::Geometry(description::Cylinder{0.5, 2}),
        description::Geometry(description::Capsule{0.5, 2}), description::Geometry(description::Ellipsoid{{1, 2, 3}}),
        description::Geometry(description::Cone{0.5, 2}), description::Geometry(description::Plane{{0, 1, 0}, {5, 6}}),
        description::Geometry(mesh), description::Geometry(hills), description::Geometry(triangle),
        description::Geometry(description::Image{"a.png", {}, 1, 200, 2, 1})}) {
    ignition::msgs::Geometry message;
    setGeometry(geometry, message);
    EXPECT_EQ(geometryFrom(message), geometry) << textOf(geometry);
  }
}

}  // namespace
}  // namespace pongsim::msgs
