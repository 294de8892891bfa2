#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
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

/// @return Whether a shape collides as convex hulls of its triangles.
bool usesHulls(const description::Geometry& geometry, bool moves);

/// The collision shape of a link: all its collisions as one Bullet shape. Each part's user pointer is the
/// `description::Surface` of its collision, its user index the number of that collision in the link. If a collision has
/// several pieces, the second user index is the piece's number.
class LinkShape {
 public:
  /// Shapes of unsupported kinds are left out.
  /// @param X_BodyLink Pose of the link frame in the frame of the body that carries the shape.
  /// @param moves Whether forces move the body: then a mesh becomes convex pieces, else its triangles are used.
  /// @param shared Shapes and surfaces that other links may use too.
  LinkShape(const description::Link& link, const Pose& X_BodyLink, bool moves, HullStore& hulls, SharedShapes& shared);

  /// Takes other sizes of the link's shapes; what is known of its surfaces stays. Call it with what the constructor was
  /// given, but for the sizes. The former `root` goes.
  void reshape(const description::Link& link, const Pose& X_BodyLink, bool moves, HullStore& hulls,
               SharedShapes& shared);

  LinkShape(const LinkShape&) = delete;
  LinkShape& operator=(const LinkShape&) = delete;

  /// What is known about a collision.
  struct Part {
    const description::Surface* surface = nullptr;
    /// Slip velocity along the friction directions per newton of friction [m/s/N].
    double slip1 = 0;
    double slip2 = 0;
    /// Orientation of the collision frame in the body frame.
    Quaternion q_BodyCollision = Quaternion::Identity();
    /// Motion of the surface; its axis is a unit vector in the body frame.
    std::optional<SurfaceMotion> motion = std::nullopt;
    /// The first friction direction in the world frame, if it is fixed to another link; set before each step.
    std::optional<Vector3> fdir1_World = std::nullopt;
    /// What `surface` points to since it was changed.
    std::shared_ptr<const description::Surface> changed = nullptr;
  };
  /// The properties of a surface that can be changed.
  struct Feel {
    /// Friction coefficients along the friction directions.
    double mu = 0;
    double mu2 = 0;
    double restitution = 0;
    bool operator==(const Feel&) const = default;
  };
  Feel feel(std::size_t collision) const;
  /// @param body Carries the shape.
  void setFeel(std::size_t collision, const Feel& feel, btCollisionObject& body);
  /// @return Whether `setFeel` has changed any surface of the body.
  static bool hasChangedSurface(const btCollisionObject& body) { return body.getUserIndex2() == kChanged; }
  /// @param collision Its number in the link.
  const Part& part(std::size_t collision) const { return collisions_[collision]; }
  Part& part(std::size_t collision) { return collisions_[collision]; }
  std::size_t partCount() const { return collisions_.size(); }
  /// Prefetches the data of the first collision; most links have one.
  void prefetch() const {
    if (!collisions_.empty()) base::prefetch(collisions_.front());
  }

  /// Saves or restores the properties of its collisions that can change at run time.
  /// @param body Carries the shape.
  void transfer(StateArchive& archive, btCollisionObject& body);

  bool empty() const { return parts_.empty(); }
  /// @return The whole shape; an empty shape if there is nothing to collide with.
  btCollisionShape* root() const { return root_; }

 private:
  static constexpr int kChanged = 1;

  void build(const description::Link& link, const Pose& X_BodyLink, bool moves, HullStore& hulls, SharedShapes& shared);
  void assemble(const std::vector<Pose>& poses);

  std::vector<std::unique_ptr<TriangleSurface>> surfaces_;
  std::vector<std::shared_ptr<btCollisionShape>> owned_;
  std::vector<std::shared_ptr<const description::Surface>> surfacesOfParts_;
  /// One for each collision.
  std::vector<Part> collisions_;
  /// Each is some of the above shapes.
  std::vector<btCollisionShape*> parts_;
  std::unique_ptr<btCollisionShape> holder_;
  btCollisionShape* root_ = nullptr;
};

}  // namespace pongsim::physics
