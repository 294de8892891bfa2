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

/// A visual at its pose.
struct Object {
  /// A formula, or a mesh.
  std::variant<Shape, const Mesh*> body;
  /// Bounding box of the body before scaling, in its own frame.
  Eigen::AlignedBox3d bounds;
  world::Slot link = world::kNoSlot;
  /// Set instead of a link; moves by itself.
  const description::Actor* actor = nullptr;
  Pose X_LinkObject;
  Vector3 scale = Vector3::Ones();
  /// Index in the scene.
  std::size_t order = 0;
  /// Top-level model.
  ModelId owner;
  std::uint32_t visibility = 0;
  double retro = 0;
  /// Whether its surface is also visible from inside.
  bool seesInside = false;

  /// Pose of the link, and the derived transform from the world to the frame of the body before scaling.
  Pose X_WorldLink;
  Vector3 position = Vector3::Zero();
  Matrix3 M_ObjectWorld = Matrix3::Identity();

  void place(const Pose& X_WorldLinkNow);

  /// In the world frame.
  Eigen::AlignedBox3d boundsInWorld() const;

  /// @param world A line in the world frame.
  /// @return Its first hit between `from` and `to`, in lengths of its direction; infinity, or more than `to`, without
  /// one.
  double firstSeenOn(const Line& world, double from, double to) const;
};

}  // namespace pongsim::sensing
