#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "physics/settings.hh"
#include "pongsim/contact.hh"
#include "pongsim/state_archive.hh"
#include "pongsim/surface_motion.hh"
#include "pongsim/types.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::physics {

class CollisionConfiguration;
class HullStore;

/// The bodies and joints of a group of entities that is set aside, and where they touched, with all that they remember.
/// Not to outlive its engine's `entities`.
class SetAside {
 public:
  SetAside();
  ~SetAside();
  SetAside(SetAside&&) noexcept;
  SetAside& operator=(SetAside&&) noexcept;

  /// Takes all of it into `archive`, or gives it back.
  /// @param links Those of the whole world, which others may touch them, in ascending order.
  void transfer(StateArchive& archive, std::span<const LinkId> links);

 private:
  friend class Engine;
  struct Content;
  std::unique_ptr<Content> content_;
};

/// Bodies, joints and contacts, and one step of them. Reads the description through `entities`, which must outlive
/// it; no Bullet type shows.
class Engine {
 public:
  /// @throws std::invalid_argument if a moving link's mass or inertia is not positive.
  explicit Engine(const world::Entities& entities, const Settings& settings = Settings());
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// Drives the joint's axis at that velocity [rad/s or m/s] until another command; 0 brakes. Not limited but by
  /// the joint's effort and, as in Fortress, its velocity limit. The value must be finite.
  /// @throws std::invalid_argument if the joint has no such axis.
  void setJointVelocityTarget(world::Slot joint, double velocity, std::size_t axis = 0);

  /// Ends what `setJointVelocityTarget` began.
  /// @throws std::invalid_argument if the joint has no such axis.
  void clearJointVelocityTarget(world::Slot joint, std::size_t axis = 0);

  /// Adds a force along the joint's axis for the next step [N m or N], up to the joint's effort. The value must
  /// be finite.
  /// @throws std::invalid_argument if the joint has no such axis.
  void addJointForce(world::Slot joint, double force, std::size_t axis = 0);

  /// Says where the axis is counted to be, for the links have been put there: angles look alike after a turn.
  void setJointPosition(world::Slot joint, double position, std::size_t axis);

  /// Adds a force at the link frame's origin and a torque for the next step, world frame [N, N m].
  void addLinkWrench(world::Slot link, const Vector3& force, const Vector3& torque);

  /// Sets the velocity of the link frame's origin [m/s] and the angular velocity [rad/s], world frame. Both must be
  /// finite.
  /// @return Whether it is a link that moves; else nothing is done.
  bool setLinkVelocity(world::Slot link, const Vector3& linear, const Vector3& angular);

  /// A force [N] and a torque [N m] on a joint's child at the joint's origin, world frame.
  struct Reaction {
    Vector3 force = Vector3::Zero();
    Vector3 torque = Vector3::Zero();
  };
  /// @return What the joint did to its child in the last step; zero before a first step after the first call.
  Reaction jointReaction(world::Slot joint);

  /// Replaces `contacts` by the points at which bodies touched in the last step, ordered by their collisions' ids, the
  /// smaller one first.
  void contacts(std::vector<Contact>& contacts) const;

  /// Makes the bodies and joints of what has come into `entities` since the last call, where they are at the start.
  /// @throws std::invalid_argument as the constructor does; nothing is changed then.
  void grow();

  /// Lets go of what has gone from `entities`. The descriptions of that must live until then.
  void remove(const world::Removal& removal);

  /// Makes everything anew from `entities`, as at the start.
  void reset();

  /// @param gravity World frame [m/s^2], from the next step on.
  void setGravity(const Vector3& gravity);

  /// Puts a link, also one that does not move, somewhere else; what touched it there is forgotten. Velocities stay, and
  /// joints are not looked at.
  void setLinkPose(world::Slot link, const Pose& X_WorldLink);

  /// Takes all that bodies, joints and contacts remember into `archive`, or makes everything anew and gives it that
  /// back, so that the next steps have the bits that they would have had. Gravity and what `entities` and
  /// `world::State` hold are not in it.
  void transfer(StateArchive& archive);

  /// Makes one step of length `dt` and writes what has moved into `state`. Allocates nothing once contacts have
  /// settled.
  /// @throws std::runtime_error naming a link whose motion has become infinite or not a number.
  void step(Time dt, world::State& state);

  /// @return The first link that was about to turn more than once in the last step, or to go faster than 1e6 m/s, and
  /// has been slowed down to that;
  /// `world::kNoSlot` where there is none.
  world::Slot slowedDown() const;

  /// @return Whether a force or a velocity other than zero is asked of one of the joint's axes.
  bool isJointDriven(world::Slot joint) const;

  /// Takes back all that is asked of the joint: its axes go on freely.
  void releaseJoint(world::Slot joint);

  /// Lets the surface of a link's collision run along, or ends that. The values must be finite, the axis not zero.
  /// @param collision Its number in the link.
  void setSurfaceMotion(world::Slot link, std::size_t collision, const std::optional<SurfaceMotion>& motion);
  /// @return How it runs along, its axis a unit vector.
  std::optional<SurfaceMotion> surfaceMotion(world::Slot link, std::size_t collision) const;

  /// Sets how fast a collision slips along its friction directions by each newton [m/s/N], finite and not below zero.
  void setSlip(world::Slot link, std::size_t collision, double slip1, double slip2);
  std::pair<double, double> slip(world::Slot link, std::size_t collision) const;
  /// Takes groups of bodies and joints out of the world; they keep what they remember. To be called when `entities` has
  /// set them aside.
  std::vector<SetAside> setAside(const world::GroupSlots& groups);

  /// Puts them back, when `entities` has brought them back, where and as they were. What touched then and is near still
  /// begins with the forces of then, so that a group that touches nothing but what has not moved goes on with the bits
  /// that it would have had.
  void bringBack(const world::GroupSlots& groups, std::vector<SetAside> parts);

 private:
  struct Parts;
  /// Of meshes, which stay the same when all else is made anew.
  std::unique_ptr<HullStore> hulls_;
  /// Has pools of several MB, which take longer to make than all else of a small world.
  std::unique_ptr<CollisionConfiguration> configuration_;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pongsim::physics
