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
#include "pongsim/geodesy.hh"
#include "pongsim/outcome.hh"
#include "pongsim/shape.hh"
#include "pongsim/surface_motion.hh"
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
class Sensor;
class Visual;
struct UrdfSource;

/// What a file says of a link's mass.
struct MassInfo {
  /// [kg]
  double mass = 0;
  /// Centre of mass in the link frame [m].
  Vector3 center = Vector3::Zero();
  /// Inertia tensor about the centre of mass, in the axes of the link [kg m^2].
  Matrix3 inertia = Matrix3::Zero();
  /// Of the axes in which the file gives the inertia, from those of the link: the rotation of its `<pose>`.
  Quaternion axes = Quaternion::Identity();
};

/// Thrown by a handle to something that is not there any more: its model or its joint was removed. A handle can be
/// asked first (`exists`). Handles of what was there at the start lead to it again after a reset, and those of what is
/// set aside with a level when it is back.
class PONGSIM_API Gone : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// No wind is faster [m/s].
inline constexpr double kFastestWind = 1e4;

/// What becomes of the velocities of what is put somewhere else.
enum class AfterMove {
  /// They turn with it: seen from the model they stay what they are, as in Fortress.
  kKeepVelocity,
  kStop,
};

/// A way to one link of a running world. A copy is the same link; it must not outlive its `Simulation`.
class PONGSIM_API Link {
 public:
  LinkId id() const { return id_; }
  /// @return Whether it is still there. If not, all other functions but `id` throw `Gone`.
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
  /// Sets the velocity of the link frame's origin [m/s] and the angular velocity [rad/s] at once, both in the world
  /// frame; does nothing to a link that does not move. One that is not finite is refused with a warning.
  void setVelocity(const Vector3& linear, const Vector3& angular);
  /// @return Its mass, and how it is spread; never changes.
  MassInfo mass() const;
  /// Puts the link somewhere else, between two steps. A link that a joint holds is refused.
  /// @return Why not, or nothing.
  std::optional<std::string> setPose(const Pose& X_WorldLink, AfterMove after = AfterMove::kKeepVelocity);
  /// @return The model that it belongs to.
  Model model() const;
  /// @return Its name with the models that hold it: "outer::inner::link".
  std::string scopedName() const;
  std::vector<Collision> collisions() const;
  std::vector<Visual> visuals() const;
  std::vector<Sensor> sensors() const;
  /// @return Whether the wind moves it: `<enable_wind>` says so of the link or of its model. As in Fortress, a link
  /// can't be kept out of it where its model is in it.
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

/// A way to one collision of a link. A copy is the same collision; it must not outlive its `Simulation`.
class PONGSIM_API Collision {
 public:
  CollisionId id() const { return id_; }
  /// @return Whether it is still there. If not, all other functions but `id` throw `Gone`.
  bool exists() const;
  /// @return Its name in the link.
  std::string_view name() const;
  /// @return Its name with all that holds it but the world: "model::link::collision".
  std::string scopedName() const;
  Link link() const;
  /// @return Pose of the collision frame in the link frame; never changes.
  Pose poseInLink() const;
  /// Lets the surface run along, as a belt does, from the next step on and until told otherwise; nothing ends that.
  /// A motion that is not finite, faster than `SurfaceMotion::kLargestSpeed` or without an axis is refused with a
  /// warning.
  void setSurfaceMotion(const std::optional<SurfaceMotion>& motion);
  /// @return How the surface runs along; nothing where it does not.
  std::optional<SurfaceMotion> surfaceMotion() const;
  /// Sets how fast this collision slips along its first and second friction direction by each newton of friction at a
  /// point [m/s/N], in place of the file's `<slip1>` and `<slip2>`, from the next step on. Values below zero, and those
  /// that are not finite, are refused with a warning.
  void setSlip(double slip1, double slip2);
  /// @return These two [m/s/N].
  std::pair<double, double> slip() const;
  /// @return Its shape in the collision frame; never changes. `Solid` makes volume, centre and bounds of it.
  Shape shape() const;
  /// @return The file that the shape is from, where it is a `<mesh>`.
  std::optional<MeshFile> meshFile() const;
  /// @return Where the file says it.
  SourcePosition sourcePosition() const;

 private:
  friend class Link;
  friend class World;
  Collision(sim::Access& access, CollisionId id) : access_(&access), id_(id) {}
  sim::Access* access_;
  CollisionId id_;
};

/// One visual of a link.
class PONGSIM_API Visual {
 public:
  Visual(VisualId id, std::string name, const Pose& X_LinkVisual)
      : id_(id), name_(std::move(name)), X_LinkVisual_(X_LinkVisual) {}
  VisualId id() const { return id_; }
  /// @return Its name in the link.
  const std::string& name() const { return name_; }
  /// @return Pose of the visual frame in the link frame; never changes.
  const Pose& poseInLink() const { return X_LinkVisual_; }

 private:
  VisualId id_;
  std::string name_;
  Pose X_LinkVisual_;
};

/// A force [N] and a torque [N m].
struct Wrench {
  Vector3 force = Vector3::Zero();
  Vector3 torque = Vector3::Zero();
};

/// What a file says of a joint's axis. Angles [rad] and their derivatives for a turning axis, [m] for a sliding one.
struct JointAxisInfo {
  /// Unit vector in the joint frame.
  Vector3 xyz = Vector3::UnitZ();
  /// Infinite where there is no limit, here and below.
  double lower = 0;
  double upper = 0;
  double effort = 0;
  double velocity = 0;
  double damping = 0;
};

/// A way to one joint of a running world. A copy is the same joint; it must not outlive its `Simulation`.
class PONGSIM_API Joint {
 public:
  JointId id() const { return id_; }
  /// @return Whether it is still there. If not, all other functions but `id` throw `Gone`.
  bool exists() const;
  /// @return Its name in the model.
  std::string_view name() const;
  /// @return Number of axes that have a position: 0 (fixed, ball), 1 (revolute, continuous, prismatic, screw) or 2
  /// (universal, revolute2).
  int axisCount() const;
  /// @return Position of the axis since the start: angle [rad], not wrapped, or travel [m].
  double position(int axis = 0) const;
  /// @return Velocity of the axis [rad/s or m/s].
  double velocity(int axis = 0) const;
  /// Drives the axis at that velocity [rad/s or m/s] from the next step on, as far as its effort limit allows,
  /// until another command comes; 0 brakes. A value that is not finite is refused with a warning.
  void setVelocityTarget(double velocity, int axis = 0);
  /// Ends what `setVelocityTarget` began: from the next step on the axis moves by forces alone.
  void clearVelocityTarget(int axis = 0);
  /// Applies a force along the axis [N m or N] during the next step. Several calls add up. A value that is not
  /// finite is refused with a warning.
  void addForce(double force, int axis = 0);
  /// Puts the axis to that position [rad or m] between two steps, and with it all that hangs on the child by other
  /// joints; velocities turn with it. Limits are not looked at. Refused where other joints hold the child to the parent
  /// or to the world.
  /// @return Why not, or nothing.
  std::optional<std::string> resetPosition(double position, int axis = 0);
  /// Likewise the velocity of the axis [rad/s or m/s].
  std::optional<std::string> resetVelocity(double velocity, int axis = 0);
  /// @return The format's name of its type: "revolute".
  std::string_view type() const;
  /// @return The link that it hangs on; nothing where that is the world.
  std::optional<Link> parent() const;
  Link child() const;
  /// @return Pose of the joint frame in the child's frame; never changes.
  Pose poseInChild() const;
  /// @return Pose of the joint frame in the frame of the parent, or of the world, while all axes are at zero; never
  /// changes.
  Pose poseInParent() const;
  /// @param axis Below `axisCount()`.
  JointAxisInfo axisInfo(int axis = 0) const;
  /// @param axis Likewise.
  /// @return What the axis has against any motion, as `<friction>` says [N m or N].
  double friction(int axis = 0) const;
  std::vector<Sensor> sensors() const;
  /// @return What the joint does to its child, at the joint frame's origin, during the last step, world frame: the
  /// forces that hold the two together and those of motor, friction, limits and commands. Measured from the first call
  /// on, which therefore returns zero; a reset of the world ends it.
  Wrench reaction() const;
  /// @return Whether the next step is to drive an axis: one was given a force or has a velocity target, either not
  /// zero.
  bool isDriven() const;

 private:
  friend class Model;
  friend class Sensor;
  friend class World;
  Joint(sim::Access& access, JointId id) : access_(&access), id_(id) {}
  sim::Access* access_;
  JointId id_;
};

/// A `<frame>` of the world, as it is now.
struct WorldFrame {
  std::string name;
  /// In the world frame.
  Pose pose;
};

/// A way to one model of a running world. A copy is the same model; it must not outlive its `Simulation`.
class PONGSIM_API Model {
 public:
  ModelId id() const { return id_; }
  /// @return Whether it is still there. If not, all other functions but `id` and `isSetAside` throw `Gone`.
  bool exists() const;
  /// @return Its own name, without the models it is nested in.
  std::string_view name() const;
  /// @return Its name with the models it is nested in: "outer::inner".
  std::string scopedName() const;
  /// @return Pose of the model frame in the world frame.
  Pose pose() const;
  /// @return Pose of the model frame in that of the model that it is nested in, or in the world frame.
  Pose poseInParent() const;
  bool isStatic() const;
  /// @return The link that the model frame moves with; nothing for a model without links.
  std::optional<Link> canonicalLink() const;
  std::vector<Link> links() const;
  std::vector<Joint> joints() const;
  /// @param name Name in this model, or with nested models: "inner::wheel".
  std::optional<Link> link(std::string_view name) const;
  std::optional<Joint> joint(std::string_view name) const;
  std::vector<Model> models() const;
  /// @return The model that it is nested in; nothing at the top level.
  std::optional<Model> parent() const;
  /// Sets the velocity of the model frame's origin [m/s] and the angular velocity [rad/s] at once, both in the world
  /// frame. All links of the model, of nested ones too, take part in the change, so that the joints' velocities stay
  /// what they are. One that is not finite is refused with a warning.
  void setVelocity(const Vector3& linear, const Vector3& angular);
  /// Puts the model frame somewhere else, between two steps, with all links of the model and of nested ones: they keep
  /// their places in it. Static models can be moved, too. One that a joint holds to something outside of it is refused.
  /// @return Why not, or nothing.
  std::optional<std::string> setPose(const Pose& X_WorldModel, AfterMove after = AfterMove::kKeepVelocity);
  /// @return What a system of the model tells its actuators, by their numbers, as rotor speeds [rad/s]; null where none
  /// has told them anything. It stands there until it is set again, the model goes, or the world is reset; do not keep
  /// the pointer.
  const std::vector<double>* actuators() const;
  /// Tells the model's actuators, in place of what they were told before; the systems that come later in this step read
  /// it already. Values that are not finite are refused with a warning.
  void setActuators(std::span<const double> values);
  /// @return The `<plugin>` elements that stand in it, not those of nested models; there as long as the model is.
  std::vector<const Element*> plugins() const;
  /// @return The URDF that it was made from; null where that was SDF. There as long as the model is.
  const UrdfSource* urdf() const;
  /// @return Whether it is not there because its levels are not loaded: it does not exist for anybody, and comes back
  /// as it is.
  bool isSetAside() const;
  /// @return Whether it, or what it is nested in, came while the world ran: a reset takes it away.
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

/// A model or actor that makes levels come and go (`<performer>`), as it is now.
struct Performer {
  /// Among those of all entities.
  std::uint64_t id = 0;
  /// There until performers come or go.
  std::string_view name;
  /// Nothing where it is an actor.
  std::optional<ModelId> model;
  /// Of the model or actor in the world frame. Around its position lies the performer's box, along the world's axes.
  Pose pose;
  /// Full lengths of the box [m].
  Vector3 size = Vector3::Ones();
};

/// A way to a running world. It must not outlive its `Simulation`.
class PONGSIM_API World {
 public:
  explicit World(sim::Access& access) : access_(&access) {}
  std::string_view name() const;
  WorldId id() const;
  /// @return Gravity in the world frame [m/s^2].
  Vector3 gravity() const;
  /// Sets the gravity from the next step on [m/s^2].
  /// @return Why not, or nothing.
  std::optional<std::string> setGravity(const Vector3& gravity);
  /// @return The models at the top level, in the order of the file; those inserted later follow.
  std::vector<Model> models() const;
  /// @param name A model's name, nested ones as "outer::inner".
  std::optional<Model> model(std::string_view name) const;
  /// @return What has that id, if it is there; likewise below.
  std::optional<Model> model(ModelId id) const;
  std::optional<Link> link(LinkId id) const;
  std::optional<Joint> joint(JointId id) const;
  std::optional<Collision> collision(CollisionId id) const;
  /// @param type As the file has it: "imu".
  /// @return The sensors of that type in the order of the file.
  std::vector<Sensor> sensors(std::string_view type) const;
  /// Replaces `contacts` by the points where collisions touched in the last step; those of one pair of collisions
  /// follow each other.
  void contacts(std::vector<Contact>& contacts) const;
  /// Makes a fixed joint that holds the child to the parent as they are now, from the next step on. While it is there
  /// the two do not touch each other.
  /// @param name Empty: one of its own.
  /// @return The joint, which belongs to no model, or why not.
  Outcome<Joint> attach(const Link& parent, const Link& child, std::string_view name = {});
  /// Removes a joint, one made by `attach` or one of the file.
  /// @return Why not, or nothing.
  std::optional<std::string> detach(const Joint& joint);
  /// @return The `<frame>`s of the world in the order of the file. One that is attached to a link moves with it, and is
  /// left out where that link is not there.
  std::vector<WorldFrame> frames() const;
  /// @return Whether a model or a light of that name could come: no other at the top level has it, nor one that is set
  /// aside.
  bool isNameFree(std::string_view name) const;
  /// @return Where the file says it.
  SourcePosition sourcePosition() const;
  /// @return Magnetic field in the world frame [T].
  Vector3 magneticField() const;
  /// @return `<heading_deg>` of the world's spherical coordinates, unless it was changed [rad].
  double heading() const;
  /// @return Where on the earth the world is, `<spherical_coordinates>` unless it was changed; nothing where nobody has
  /// said it.
  std::optional<TangentPlane> tangentPlane() const;
  /// Says where on the earth the world is.
  /// @param origin Of the world's frame.
  /// @param heading Of its x axis, anticlockwise from east [rad].
  /// @return Why not, or nothing.
  std::optional<std::string> setPlace(const GeodeticPosition& origin, double heading);
  /// @return Velocity of the air, world frame [m/s]: `<wind>` of the world unless it was changed. By itself it moves
  /// nothing.
  Vector3 wind() const;
  /// Sets the velocity of the air, world frame [m/s].
  /// @return Why not (it is faster than `kFastestWind`), or nothing.
  std::optional<std::string> setWind(const Vector3& wind);
  /// @return Simulated seconds a second that the world asks for, `<real_time_factor>` unless it was changed; 0 means as
  /// many as possible.
  double realTimeFactor() const;
  /// Changes that until the world is reset.
  /// @return Why not (it is not finite, or below 0), or nothing.
  std::optional<std::string> setRealTimeFactor(double factor);
  /// Replaces `performers` by those that are there, whether levels are used or not.
  void performers(std::vector<Performer>& performers) const;
  /// Lets a model of the top level perform, until it is removed or the world is reset.
  /// @param size Full lengths of its box [m].
  /// @param name Of the performer; empty: "perf_" and the model's.
  /// @return Why not, or nothing.
  std::optional<std::string> addPerformer(const Model& model, const Vector3& size, std::string_view name = {});

 private:
  friend class Actor;
  friend class Appearance;
  friend class Batteries;
  friend class BeamScene;
  friend class CameraScene;
  friend class LinkGroup;
  friend class Scene;
  sim::Access* access_;
};

}  // namespace pongsim
