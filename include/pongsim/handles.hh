#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pongsim/contact.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/export.hh"
#include "pongsim/geometry/geodesy.hh"
#include "pongsim/geometry/shape.hh"
#include "pongsim/geometry/surface_motion.hh"
#include "pongsim/outcome.hh"
#include "pongsim/types.hh"

namespace pongsim {

namespace sim {
class Access;
class SystemSet;
}  // namespace sim

class Actor;
class Appearance;
class Batteries;
class BeamScene;
class CameraScene;
class Collision;
class Element;
class Link;
class LinkGroup;
class Scene;
class Simulation;
class Model;
class PhysicalProperties;
class RayScene;
class Sensor;
class Visual;
struct UrdfSource;

/// Mass properties of a link, as in the file unless changed (`PhysicalProperties`).
struct MassInfo {
  /// [kg]
  double mass = 0;
  /// Centre of mass in the link frame [m].
  Vector3 center = Vector3::Zero();
  /// Inertia tensor about the centre of mass, in the axes of the link frame [kg m^2].
  Matrix3 inertia = Matrix3::Zero();
  /// Orientation of the axes in which the file gives the inertia, in the link frame: the rotation of its `<pose>`.
  Quaternion axes = Quaternion::Identity();
};

/// Thrown by a handle whose model, joint or other entity no longer exists; `exists` checks first. Handles to entities
/// of the file become valid again after a reset, and those to entities of an unloaded level when the level is loaded
/// again.
class PONGSIM_API Gone : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Largest wind speed [m/s].
inline constexpr double kFastestWind = 1e4;

/// What happens to velocities when something is moved.
enum class AfterMove {
  /// They rotate with it: relative to the model they stay the same, as in Fortress.
  kKeepVelocity,
  kStop,
};

/// Handle to a link of a running world. Copies refer to the same link. Must not outlive its `Simulation`.
class PONGSIM_API Link {
 public:
  LinkId id() const { return id_; }
  /// @return Whether it exists. If not, all other functions but `id` throw `Gone`.
  bool exists() const;
  /// @return Its name in the model.
  std::string_view name() const;
  /// @return Pose of the link frame in the world frame.
  Pose pose() const;
  /// @return Pose of the link frame in the frame of its model.
  Pose poseInModel() const;
  /// @return Velocity of the link frame's origin, world frame [m/s].
  Vector3 linearVelocity() const;
  /// @return Angular velocity, world frame [rad/s].
  Vector3 angularVelocity() const;
  /// Applies a force at the link frame's origin and a torque during the next step, both in the world frame
  /// [N, N m]. Several calls add up.
  void addWrench(const Vector3& force, const Vector3& torque);
  /// Sets the velocity of the link frame's origin [m/s] and the angular velocity [rad/s] immediately, both in the world
  /// frame. No effect on a static link. A velocity that is not finite is refused with a warning.
  void setVelocity(const Vector3& linear, const Vector3& angular);
  /// @return Its mass properties; constant unless changed by `PhysicalProperties`.
  MassInfo mass() const;
  /// Moves the link, between two steps. A link connected by a joint can't be moved.
  Outcome<void> setPose(const Pose& X_WorldLink, AfterMove after = AfterMove::kKeepVelocity);
  /// @return Its model.
  Model model() const;
  /// @return Its name with its models: "outer::inner::link".
  std::string scopedName() const;
  std::vector<Collision> collisions() const;
  std::vector<Visual> visuals() const;
  std::vector<Sensor> sensors() const;
  /// @return Whether wind acts on it: `<enable_wind>` is set for the link or its model. As in Fortress, a link can't be
  /// excluded if its model is included.
  bool isInWind() const;

 private:
  friend class Collision;
  friend class Joint;
  friend class Model;
  friend class Sensor;
  friend class World;
  Link(sim::Access& access, LinkId id) : access_(&access), id_(id) {}
  sim::Access* access_;
  LinkId id_;
};

/// Handle to a collision of a link. Copies refer to the same collision. Must not outlive its `Simulation`.
class PONGSIM_API Collision {
 public:
  CollisionId id() const { return id_; }
  /// @return Whether it exists. If not, all other functions but `id` throw `Gone`.
  bool exists() const;
  /// @return Its name in the link.
  std::string_view name() const;
  /// @return Its name with all its parents but the world: "model::link::collision".
  std::string scopedName() const;
  Link link() const;
  /// @return Pose of the collision frame in the link frame; constant.
  Pose poseInLink() const;
  /// Makes the surface move like a belt from the next step on, until changed. A motion that is not finite, faster than
  /// `SurfaceMotion::kLargestSpeed` or without an axis is refused with a warning.
  void setSurfaceMotion(const std::optional<SurfaceMotion>& motion);
  /// @return The motion of the surface; nothing if it does not move.
  std::optional<SurfaceMotion> surfaceMotion() const;
  /// Sets the slip velocities along the first and second friction direction per newton of friction at a contact point
  /// [m/s/N], from the next step on. They replace `<slip1>` and `<slip2>` of the file. Values below zero or not finite
  /// are refused with a warning.
  void setSlip(double slip1, double slip2);
  /// @return The values of `setSlip` [m/s/N].
  std::pair<double, double> slip() const;
  /// @return Its shape in the collision frame; constant. `Solid` computes its volume, centroid and bounds.
  Shape shape() const;
  /// @return The file of a `<mesh>`; otherwise nothing.
  std::optional<MeshFile> meshFile() const;
  /// @return Its position in the file.
  SourcePosition sourcePosition() const;

 private:
  friend class Link;
  friend class World;
  Collision(sim::Access& access, CollisionId id) : access_(&access), id_(id) {}
  sim::Access* access_;
  CollisionId id_;
};

/// A visual of a link.
class PONGSIM_API Visual {
 public:
  Visual(VisualId id, std::string name, const Pose& X_LinkVisual)
      : id_(id), name_(std::move(name)), X_LinkVisual_(X_LinkVisual) {}
  VisualId id() const { return id_; }
  /// @return Its name in the link.
  const std::string& name() const { return name_; }
  /// @return Pose of the visual frame in the link frame; constant.
  const Pose& poseInLink() const { return X_LinkVisual_; }

 private:
  VisualId id_;
  std::string name_;
  Pose X_LinkVisual_;
};

/// Force [N] and torque [N m].
struct Wrench {
  Vector3 force = Vector3::Zero();
  Vector3 torque = Vector3::Zero();
};

/// An axis of a joint, as in the file unless changed (`PhysicalProperties`). Units are [rad] for a rotational axis, [m]
/// for a translational one, and their derivatives.
struct JointAxisInfo {
  /// Unit vector in the joint frame.
  Vector3 xyz = Vector3::UnitZ();
  /// Infinite if unlimited, here and below.
  double lower = 0;
  double upper = 0;
  double effort = 0;
  double velocity = 0;
  double damping = 0;
};

/// Handle to a joint of a running world. Copies refer to the same joint. Must not outlive its `Simulation`.
class PONGSIM_API Joint {
 public:
  JointId id() const { return id_; }
  /// @return Whether it exists. If not, all other functions but `id` throw `Gone`.
  bool exists() const;
  /// @return Its name in the model.
  std::string_view name() const;
  /// @return The number of axes with a position: 0 (fixed, ball), 1 (revolute, continuous, prismatic, screw) or 2
  /// (universal, revolute2).
  int axisCount() const;
  /// @return Position of the axis relative to the start: angle [rad], not wrapped, or distance [m].
  double position(int axis = 0) const;
  /// @return Velocity of the axis [rad/s or m/s].
  double velocity(int axis = 0) const;
  /// Drives the axis at a velocity [rad/s or m/s] from the next step on, within its effort limit, until the next
  /// command; 0 brakes. A value that is not finite is refused with a warning.
  void setVelocityTarget(double velocity, int axis = 0);
  /// Ends `setVelocityTarget`: from the next step on, only forces move the axis.
  void clearVelocityTarget(int axis = 0);
  /// Applies a force along the axis [N m or N] during the next step. Several calls add up. A value that is not finite
  /// is refused with a warning.
  void addForce(double force, int axis = 0);
  /// Moves the axis to a position [rad or m] between two steps, together with everything connected to the child by
  /// other joints; velocities rotate along. Limits are ignored. Refused if other joints also connect the child to the
  /// parent or the world.
  Outcome<void> resetPosition(double position, int axis = 0);
  /// The same for the velocity of the axis [rad/s or m/s].
  Outcome<void> resetVelocity(double velocity, int axis = 0);
  /// @return Its type in SDF: "revolute".
  std::string_view type() const;
  /// @return The parent link; nothing if that is the world.
  std::optional<Link> parent() const;
  Link child() const;
  /// @return Pose of the joint frame in the child's frame; constant.
  Pose poseInChild() const;
  /// @return Pose of the joint frame in the frame of the parent, or of the world, with all axes at zero; constant.
  Pose poseInParent() const;
  /// @param axis Below `axisCount()`.
  JointAxisInfo axisInfo(int axis = 0) const;
  /// @param axis Below `axisCount()`.
  /// @return Friction of the axis, as in `<friction>` [N m or N].
  double friction(int axis = 0) const;
  std::vector<Sensor> sensors() const;
  /// @return The wrench that the joint applied to its child during the last step, at the joint frame's origin, world
  /// frame: constraint forces, motor, friction, limits and commands. Measured from the first call on, which therefore
  /// returns zero, until the world is reset.
  Wrench reaction() const;
  /// @return Whether the next step drives an axis: it has a nonzero force or velocity target.
  bool isDriven() const;

 private:
  friend class Model;
  friend class Sensor;
  friend class World;
  Joint(sim::Access& access, JointId id) : access_(&access), id_(id) {}
  sim::Access* access_;
  JointId id_;
};

/// A `<frame>` of the world at its current pose.
struct WorldFrame {
  std::string name;
  /// In the world frame.
  Pose pose;
};

/// Handle to a model of a running world. Copies refer to the same model. Must not outlive its `Simulation`.
class PONGSIM_API Model {
 public:
  ModelId id() const { return id_; }
  /// @return Whether it exists. If not, all other functions but `id` and `isSetAside` throw `Gone`.
  bool exists() const;
  /// @return Its own name, without parent models.
  std::string_view name() const;
  /// @return Its name with its parent models: "outer::inner".
  std::string scopedName() const;
  /// @return Pose of the model frame in the world frame.
  Pose pose() const;
  /// @return Pose of the model frame in the frame of its parent model, or in the world frame.
  Pose poseInParent() const;
  bool isStatic() const;
  /// @return The link to which the model frame is attached; nothing for a model without links.
  std::optional<Link> canonicalLink() const;
  std::vector<Link> links() const;
  std::vector<Joint> joints() const;
  /// @param name Name in this model, or with nested models: "inner::wheel".
  std::optional<Link> link(std::string_view name) const;
  std::optional<Joint> joint(std::string_view name) const;
  std::vector<Model> models() const;
  /// @return The parent model; nothing at the top level.
  std::optional<Model> parent() const;
  /// Sets the velocity of the model frame's origin [m/s] and the angular velocity [rad/s] immediately, both in the
  /// world frame. All links, including those of nested models, change their velocities accordingly, so that joint
  /// velocities stay the same. A velocity that is not finite is refused with a warning.
  void setVelocity(const Vector3& linear, const Vector3& angular);
  /// Moves the model frame, between two steps, with all links of the model and its nested models; their poses in the
  /// model stay the same. Static models can be moved too. Refused if a joint connects the model to something outside of
  /// it.
  Outcome<void> setPose(const Pose& X_WorldModel, AfterMove after = AfterMove::kKeepVelocity);
  /// @return The commands to the model's actuators by number, such as rotor speeds [rad/s]; null if none were given.
  /// Valid until the next command, the removal of the model or a reset; do not keep the pointer.
  const std::vector<double>* actuators() const;
  /// Replaces the commands to the model's actuators; systems called later in this step see them already. Values that
  /// are not finite are refused with a warning.
  void setActuators(std::span<const double> values);
  /// @return Its own `<plugin>` elements, without those of nested models; valid as long as the model exists.
  std::vector<const Element*> plugins() const;
  /// @return Its URDF source; null if it was loaded from SDF. Valid as long as the model exists.
  const UrdfSource* urdf() const;
  /// @return Whether it is in levels that are not loaded. It does not exist then, and returns unchanged when a level is
  /// loaded.
  bool isSetAside() const;
  /// @return Whether it, or its parent model, was inserted at run time; a reset removes it.
  bool isInserted() const;

 private:
  friend class Link;
  friend class Simulation;
  friend class World;
  friend class sim::SystemSet;
  Model(sim::Access& access, ModelId id) : access_(&access), id_(id) {}
  void changeVelocity(const Vector3& origin, const Vector3& linear, const Vector3& angular);
  sim::Access* access_;
  ModelId id_;
};

/// A performer: a model or actor around which levels are loaded.
struct Performer {
  /// Unique among all entities.
  std::uint64_t id = 0;
  /// Valid until performers are added or removed.
  std::string_view name;
  /// Unset for an actor.
  std::optional<ModelId> model;
  /// Pose of the model or actor in the world frame. The performer's box is centred on its position and aligned with the
  /// world's axes.
  Pose pose;
  /// Side lengths of the box [m].
  Vector3 size = Vector3::Ones();
};

/// Handle to a running world. Must not outlive its `Simulation`.
class PONGSIM_API World {
 public:
  explicit World(sim::Access& access) : access_(&access) {}
  std::string_view name() const;
  WorldId id() const;
  /// @return Gravity in the world frame [m/s^2].
  Vector3 gravity() const;
  /// Sets gravity from the next step on [m/s^2].
  Outcome<void> setGravity(const Vector3& gravity);
  /// @return The top-level models in the order of the file, followed by inserted ones.
  std::vector<Model> models() const;
  /// @param name A model's name; for nested ones "outer::inner".
  std::optional<Model> model(std::string_view name) const;
  /// @return The model with that id, if it exists; the same for the next functions.
  std::optional<Model> model(ModelId id) const;
  std::optional<Link> link(LinkId id) const;
  std::optional<Joint> joint(JointId id) const;
  std::optional<Collision> collision(CollisionId id) const;
  /// @param type As in the file: "imu".
  /// @return The sensors of that type in the order of the file.
  std::vector<Sensor> sensors(std::string_view type) const;
  /// Replaces `contacts` by the contact points of the last step, grouped by pairs of collisions.
  void contacts(std::vector<Contact>& contacts) const;
  /// Connects two links at their current poses with a fixed joint, from the next step on. Meanwhile they do not collide
  /// with each other.
  /// @param name Empty: chosen automatically.
  /// @return The joint, which belongs to no model, or why it was refused.
  Outcome<Joint> attach(const Link& parent, const Link& child, std::string_view name = {});
  /// Removes a joint, made by `attach` or from the file.
  Outcome<void> detach(const Joint& joint);
  /// @return The `<frame>`s of the world in the order of the file. A frame attached to a link moves with it, and is
  /// left out if the link does not exist.
  std::vector<WorldFrame> frames() const;
  /// @return Whether a model or light with that name can be added: no other at the top level has it, even in an
  /// unloaded level.
  bool isNameFree(std::string_view name) const;
  /// @return Its position in the file.
  SourcePosition sourcePosition() const;
  /// @return Magnetic field in the world frame [T].
  Vector3 magneticField() const;
  /// @return The world's heading: `<heading_deg>` of its spherical coordinates unless changed [rad].
  double heading() const;
  /// @return The world's place on the earth: `<spherical_coordinates>` unless changed; nothing if it was never given.
  std::optional<TangentPlane> tangentPlane() const;
  /// Sets the world's place on the earth.
  /// @param origin Of the world frame.
  /// @param heading Of its x axis, anticlockwise from east [rad].
  Outcome<void> setPlace(const GeodeticPosition& origin, double heading);
  /// @return Wind velocity, world frame [m/s]: `<wind>` of the world unless changed. By itself it moves nothing.
  Vector3 wind() const;
  /// Sets the wind velocity, world frame [m/s].
  /// Refused if it is faster than `kFastestWind`.
  Outcome<void> setWind(const Vector3& wind);
  /// @return The desired real-time factor, simulated seconds per second: `<real_time_factor>` unless changed; 0: as
  /// fast as possible.
  double realTimeFactor() const;
  /// Changes the desired real-time factor until the world is reset.
  /// Refused if it is not finite or below 0.
  Outcome<void> setRealTimeFactor(double factor);
  /// Replaces `performers` by the existing ones, whether levels are used or not.
  void performers(std::vector<Performer>& performers) const;
  /// Makes a top-level model a performer, until it is removed or the world is reset.
  /// @param size Side lengths of its box [m].
  /// @param name Of the performer; empty: "perf_" and the model's name.
  Outcome<void> addPerformer(const Model& model, const Vector3& size, std::string_view name = {});

 private:
  friend class Actor;
  friend class Appearance;
  friend class Batteries;
  friend class BeamScene;
  friend class CameraScene;
  friend class LinkGroup;
  friend class PhysicalProperties;
  friend class RayScene;
  friend class Scene;
  sim::Access* access_;
};

}  // namespace pongsim
