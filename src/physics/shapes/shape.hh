#pragma once

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "base/prefetch.hh"
#include "description/link.hh"
#include "physics/hulls/hull_store.hh"
#include "physics/shapes/mesh_shape.hh"
#include "physics/shapes/shared_shapes.hh"
#include "pongsim/geometry/surface_motion.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim::physics {

/// @return Whether a shape collides as convex pieces of its triangles.
bool usesHulls(const description::Geometry& geometry, bool moves);

/// What a link collides with: all its collisions as one Bullet shape. Each part's user pointer is the
/// `description::Surface` of its collision, its user index the number of that collision in the link; of several pieces
/// that one collision is made of, the second user index is the piece's number.
class LinkShape {
 public:
  /// Shapes of kinds that are not built yet are left out.
  /// @param X_BodyLink Pose of the link frame in the frame of the body that bears the shape.
  /// @param moves Forces move the body: a mesh is made of convex pieces then, else of its triangles.
  /// @param shared What others may have, too.
  LinkShape(const description::Link& link, const Pose& X_BodyLink, bool moves, HullStore& hulls, SharedShapes& shared);

  LinkShape(const LinkShape&) = delete;
  LinkShape& operator=(const LinkShape&) = delete;

  /// What is known of a collision.
  struct Part {
    const description::Surface* surface = nullptr;
    /// How fast it slips along the friction directions by each newton [m/s/N].
    double slip1 = 0;
    double slip2 = 0;
    /// Orientation of the collision frame in the body frame.
    Quaternion q_BodyCollision = Quaternion::Identity();
    /// How the surface runs along, its axis a unit vector in the body frame.
    std::optional<SurfaceMotion> motion = std::nullopt;
    /// The first friction direction in the world frame, where it is that of another link; set before each step.
    std::optional<Vector3> fdir1_World = std::nullopt;
  };
  /// @param collision Its number in the link.
  const Part& part(std::size_t collision) const { return collisions_[collision]; }
  Part& part(std::size_t collision) { return collisions_[collision]; }
  std::size_t partCount() const { return collisions_.size(); }
  /// Asks for the memory of what is known of the first collision; most links have one.
  void prefetch() const {
    if (!collisions_.empty()) base::prefetch(collisions_.front());
  }

  /// What of its collisions may change while running.
  void transfer(StateArchive& archive);

  bool empty() const { return parts_.empty(); }
  /// @return The whole; an empty shape where there is nothing to collide with.
  btCollisionShape* root() const { return root_; }

 private:
  void assemble(const std::vector<Pose>& poses);

  std::vector<std::unique_ptr<TriangleSurface>> surfaces_;
  std::vector<std::shared_ptr<btCollisionShape>> owned_;
  std::vector<std::shared_ptr<const description::Surface>> surfacesOfParts_;
  /// One a collision.
  std::vector<Part> collisions_;
  /// Some of the above shapes each.
  std::vector<btCollisionShape*> parts_;
  std::unique_ptr<btCollisionShape> holder_;
  btCollisionShape* root_ = nullptr;
};

}  // namespace pongsim::physics
