#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "physics/settings.hh"
#include "pongsim/contact.hh"
#include "pongsim/geometry/surface_motion.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::base {
class Arena;
}  // namespace pongsim::base

namespace pongsim::physics {

class CollisionConfiguration;
class HullStore;

/// Bodies, joints and contacts, and one step of them. Reads the description from `entities`, which must outlive it. No
/// Bullet types are visible.
class Engine {
 public:
  /// @throws std::invalid_argument if a moving link's mass or inertia is not positive.
  explicit Engine(const world::Entities& entities, const Settings& settings = Settings());
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// @return Whether the joint has that axis.
  bool hasAxis(world::Slot joint, std::size_t axis) const;

  /// Drives the joint's axis at a velocity [rad/s or m/s] until the next command; 0 brakes. Limited only by the joint's
  /// effort and, as in Fortress, its velocity limit. The value must be finite.
  /// @throws std::invalid_argument if the joint does not have that axis.
  void setJointVelocityTarget(world::Slot joint, double velocity, std::size_t axis = 0);

  /// Ends `setJointVelocityTarget`.
  /// @throws std::invalid_argument if the joint does not have that axis.
  void clearJointVelocityTarget(world::Slot joint, std::size_t axis = 0);

  /// Adds a force along the joint's axis for the next step [N m or N], up to the joint's effort. The value must be
  /// finite.
  /// @throws std::invalid_argument if the joint does not have that axis.
  void addJointForce(world::Slot joint, double force, std::size_t axis = 0);

  /// Sets the position of the axis, including whole turns, after its links were moved.
  void setJointPosition(world::Slot joint, double position, std::size_t axis);

  /// Adds a force at the link frame's origin and a torque for the next step, world frame [N, N m].
  void addLinkWrench(world::Slot link, const Vector3& force, const Vector3& torque);

  /// Sets the velocity of the link frame's origin [m/s] and the angular velocity [rad/s], world frame. Both must be
  /// finite.
  /// @return Whether the link can move; otherwise nothing happens.
  bool setLinkVelocity(world::Slot link, const Vector3& linear, const Vector3& angular);

  /// Force [N] and torque [N m] on a joint's child at the joint's origin, world frame.
  struct Reaction {
    Vector3 force = Vector3::Zero();
    Vector3 torque = Vector3::Zero();
  };
  /// @return The wrench of the joint on its child in the last step; zero until the first step after the first call.
  Reaction jointReaction(world::Slot joint);

  /// Replaces `contacts` by the contact points of the last step, ordered by the collisions' ids, the smaller one first.
  void contacts(std::vector<Contact>& contacts) const;

  /// Adds bodies and joints of new `entities`, at their start poses.
  /// @throws std::invalid_argument like the constructor; then nothing is changed.
  void grow();

  /// Removes what was removed from `entities`. Its descriptions must live until then. Does not allocate, so that it
  /// can't fail halfway.
  void remove(const world::Removal& removal);

  /// Recreates everything from `entities`, as at the start.
  void reset();

  /// @param gravity World frame [m/s^2], from the next step on.
  void setGravity(const Vector3& gravity);

  /// Moves a link, even a static one, and discards its contacts. Velocities stay, and joints are ignored.
  void setLinkPose(world::Slot link, const Pose& X_WorldLink);

  /// Saves the state of bodies, joints and contacts, or recreates everything and restores it, so that the next steps
  /// have the same bits. Gravity and the contents of `entities` and `world::State` are not included.
  void transfer(StateArchive& archive);

  /// Makes one step of length `dt` and writes moved links to `state`. Does not allocate once contacts have settled.
  /// @throws std::runtime_error naming a link with infinite or NaN motion.
  void step(Time dt, world::State& state);

  /// @return The first link that would have turned more than once in the last step, or exceeded 1e6 m/s, and was slowed
  /// down to that; `world::kNoSlot` without one.
  world::Slot slowedDown() const;

  /// Pairs of links whose bounding boxes overlap.
  struct Crowding {
    std::size_t pairs;
    /// The rest of them is ignored, and can't touch.
    std::size_t most;
  };
  /// @return Nothing if all pairs are looked at, as usual. The cost and memory of contacts grow with the pairs.
  std::optional<Crowding> crowding() const;

  /// @return Whether an axis of the joint has a nonzero force or velocity target.
  bool isJointDriven(world::Slot joint) const;

  /// Removes all commands to the joint: its axes move freely.
  void releaseJoint(world::Slot joint);

  /// Sets or ends the surface motion of a link's collision. The values must be finite, the axis not zero.
  /// @param collision Index in the link.
  void setSurfaceMotion(world::Slot link, std::size_t collision, const std::optional<SurfaceMotion>& motion);
  /// @return The surface motion, with a unit axis.
  std::optional<SurfaceMotion> surfaceMotion(world::Slot link, std::size_t collision) const;

  /// Sets the slip of a collision along its friction directions [m/s/N], finite and not negative.
  void setSlip(world::Slot link, std::size_t collision, double slip1, double slip2);
  std::pair<double, double> slip(world::Slot link, std::size_t collision) const;

  /// Mass of a link [kg], and how many times the file's moments of inertia the present ones are: along all principal
  /// axes, and beyond that along each.
  struct Mass {
    double mass = 0;
    double inertiaFactor = 1;
    Vector3 stretch = Vector3::Ones();
  };
  /// @return Mass zero if the link does not move.
  Mass mass(world::Slot link) const;
  /// Changes the mass of a moving link; its centre of mass and principal axes stay. The numbers must be positive.
  /// @return Whether the link can have it, with its added mass.
  bool canHave(world::Slot link, const Mass& mass) const;
  void setMass(world::Slot link, const Mass& mass);
  /// Principal moments of inertia of the file [kg m^2], and the orientation of these axes in the link frame.
  struct Inertia {
    Vector3 moments = Vector3::Zero();
    Quaternion q_LinkAxes = Quaternion::Identity();
  };
  Inertia inertiaOfFile(world::Slot link) const;

  /// Takes the sizes of a link's shapes, which have changed in `entities`. Discards the link's contacts.
  void reshape(world::Slot link);

  /// Friction coefficients along both friction directions, and restitution.
  struct Feel {
    double mu = 0;
    double mu2 = 0;
    double restitution = 0;
  };
  Feel feel(world::Slot link, std::size_t collision) const;
  /// The numbers must be finite and not negative. Discards the link's contacts.
  void setFeel(world::Slot link, std::size_t collision, const Feel& feel);

  /// Damping [N m s/rad or N s/m] and friction [N m or N] of a joint's axis.
  struct Resistance {
    double damping = 0;
    double friction = 0;
  };
  Resistance resistance(world::Slot joint, std::size_t axis) const;
  /// The numbers must be finite and not negative.
  void setResistance(world::Slot joint, std::size_t axis, const Resistance& resistance);

  /// Positions between which an axis moves [rad or m], locked if both are the same, and the effort of its motor and its
  /// commands [N m or N]. May be infinite.
  struct Bounds {
    double lower = 0;
    double upper = 0;
    double effort = 0;
  };
  Bounds bounds(world::Slot joint, std::size_t axis) const;
  /// `lower` must not be above `upper`, `effort` not negative, and no number NaN.
  void setBounds(world::Slot joint, std::size_t axis, const Bounds& bounds);

  /// Takes links and their joints out of all steps, or back into them, after `entities` has set them aside or returned
  /// them. They keep their state. Contacts that still exist on return start with their former forces, so that links in
  /// contact only with others that have not moved continue with the same bits.
  void setAside(const world::Entities::Switched& switched);

 private:
  struct Parts;
  /// Of meshes; kept when everything else is recreated.
  std::unique_ptr<HullStore> hulls_;
  std::unique_ptr<CollisionConfiguration> configuration_;
  /// Of bodies, joints and contacts.
  std::unique_ptr<base::Arena> arena_;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pongsim::physics
