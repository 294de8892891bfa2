#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>

#include "description/actor.hh"
#include "pongsim/types.hh"
#include "sensing/mesh.hh"
#include "sensing/shape.hh"
#include "world/entities.hh"

namespace pongsim::sensing {

/// A visual in its place.
struct Object {
  /// A formula, or triangles.
  std::variant<Shape, const Mesh*> body;
  /// Of the body, before scaling, in its own frame.
  Eigen::AlignedBox3d bounds;
  world::Slot link = world::kNoSlot;
  /// In place of a link; it moves by itself.
  const description::Actor* actor = nullptr;
  Pose X_LinkObject;
  Vector3 scale = Vector3::Ones();
  /// Its place among all objects of the scene.
  std::size_t order = 0;
  /// Model at the top level.
  ModelId owner;
  std::uint32_t visibility = 0;
  double retro = 0;
  /// Its surface is seen from inside, too.
  bool seesInside = false;

  /// Where the link is, and what follows from it: the way from the world to the frame of the body before scaling.
  Pose X_WorldLink;
  Vector3 position = Vector3::Zero();
  Matrix3 M_ObjectWorld = Matrix3::Identity();

  void place(const Pose& X_WorldLinkNow);

  /// In the world frame.
  Eigen::AlignedBox3d boundsInWorld() const;

  /// @param world A line in the world frame.
  /// @return Its first point between `from` and `to` where the object is seen, in lengths of its direction; infinity or
  /// more than `to` where there is none.
  double firstSeenOn(const Line& world, double from, double to) const;
};

}  // namespace pongsim::sensing
