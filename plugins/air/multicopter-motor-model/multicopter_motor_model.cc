#include <ignition/msgs/actuators.pb.h>
#include <ignition/msgs/double.pb.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "first_order_filter.hh"
#include "pongsim/commands.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

// Maximum speed [rad/s].
constexpr double kFastestRotor = 1e6;

/// Spins a rotor at the commanded speed, and applies its thrust, drag and torques to the rotor and its parent.
class MulticopterMotorModel : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Spins a rotor at the commanded speed, and applies its thrust, drag and torques.",
                   Declaration::Place::kModel);
    declaration.parameter("robotNamespace", &nameSpace_, "", "prefix of the topics").otherwise("M");
    declaration.parameter("jointName", &jointName_, "", "joint of the rotor; torques act on its parent").required();
    declaration.parameter("linkName", &linkName_, "", "link of the rotor; thrust acts along its z axis").required();
    declaration.parameter("actuator_number", &actuator_, "", "index in the command")
        .atLeast(0)
        .otherwise("motorNumber");
    declaration.parameter("motorNumber", &number_, "", "the same in worlds for Fortress").atLeast(0);
    declaration.parameter("turningDirection", &directionName_, "", "'cw' or 'ccw', seen from above");
    declaration.parameter("motorType", &type_, "", "'velocity'; 'position' and 'force' have no effect, as in Fortress");
    declaration.parameter("commandSubTopic", &commandTopic_, "", "command topic, in the namespace");
    declaration.parameter("motorSpeedPubTopic", &speedTopic_, "", "speed topic, in the namespace; default: none");
    declaration.parameter("maxRotVelocity", &maximum_, "rad/s", "limit of the command").atLeast(0);
    declaration.parameter("motorConstant", &motorConstant_, "N s^2/rad^2", "thrust per squared speed");
    declaration.parameter("momentConstant", &momentConstant_, "m", "reaction torque per thrust");
    declaration.parameter("rotorDragCoefficient", &dragCoefficient_, "N s^2/(m rad)",
                          "drag per rotor speed and lateral airspeed");
    declaration.parameter("rollingMomentCoefficient", &rollingCoefficient_, "N s^2/rad",
                          "torque on the parent per rotor speed and lateral airspeed");
    declaration.parameter("timeConstantUp", &timeUp_, "s", "time constant while the speed rises").atLeast(0);
    declaration.parameter("timeConstantDown", &timeDown_, "s", "time constant while the speed falls").atLeast(0);
    declaration
        .parameter("rotorVelocitySlowdownSim", &slowdown_, "",
                   "factor by which the joint turns slower than the simulated rotor")
        .above(0);
    declaration.subscribes("/<robotNamespace>/<commandSubTopic>", "ignition.msgs.Actuators",
                           "`velocity[actuator_number]` [rad/s], which holds until the next command; ignored if a "
                           "system of the model commands its rotors");
    declaration.publishes("/<robotNamespace>/<motorSpeedPubTopic>", "ignition.msgs.Double",
                          "speed of the rotor [rad/s], negative if it turns clockwise, in each step");
  }

  void configure(const SystemContext& context) override {
    log_ = &context.log;
    world_ = &context.world;
    model_ = context.model;
    joint_ = requiredJoint(context.sdf, "jointName", *model_);
    parent_ = joint_->parent();
    if (!parent_) {
      refuse(*context.sdf.child("jointName"),
             "<jointName> '" + jointName_ + "' is connected to the world, which can't fly");
    }
    link_ = requiredLink(context.sdf, "linkName", *model_);
    center_ = link_->mass().center;
    axis_ = joint_->poseInChild().rotation * joint_->axisInfo().xyz;
    if (actuator_ >= 0) number_ = actuator_;
    checkType(context.sdf, context.diagnostics);
    checkDirection(context.sdf, context.diagnostics);
    warnOfOddValues(context.sdf, context.diagnostics);
    filter_ = FirstOrderFilter(timeUp_, timeDown_);

    const std::string prefix = (nameSpace_.empty() ? std::string(model_->name()) : nameSpace_) + "/";
    command_ = context.node.subscribe<ignition::msgs::Actuators>(
        cleanTopic(prefix + commandTopic_), [this](const ignition::msgs::Actuators& message) { receive(message); },
        kCommands);
    if (!speedTopic_.empty()) {
      speed_ = context.node.advertise<ignition::msgs::Double>(cleanTopic(prefix + speedTopic_));
    }
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    const double dt = toSeconds(info.dt);
    if (const std::vector<double>* told = model_->actuators()) take(*told);
    warnOfAliasing(dt);
    applyForces(joint_->velocity() * slowdown_);
    joint_->setVelocityTarget(direction_ * filter_.update(reference_, dt) / slowdown_);
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused || !speed_ || !speed_.hasSubscribers()) return;
    ignition::msgs::Double message;
    message.set_data(joint_->velocity() * slowdown_);
    speed_.publish(message);
  }

  void reset() override {
    filter_.reset();
    reference_ = 0;
    hasWarnedOfCommand_ = hasWarnedOfAliasing_ = false;
  }

  void transfer(StateArchive& archive) override {
    filter_.transfer(archive);
    archive(reference_);
  }

 private:
  void checkType(const Element& sdf, Diagnostics& diagnostics) const {
    if (type_ == "velocity") return;
    const Element& element = *sdf.child("motorType");
    if (type_ == "position" || type_ == "force") {
      refuse(element, "a motor of the type '" + type_ + "' has no effect, as in Fortress",
             type_ == "force" ? "use ApplyJointForce to command a torque"
                              : "use JointPositionController to command an angle");
    }
    diagnostics.warning(element.position, "<motorType> is '" + type_ + "': 'velocity' is used",
                        "it can be 'velocity', 'position' or 'force'");
  }

  void checkDirection(const Element& sdf, Diagnostics& diagnostics) {
    direction_ = directionName_ == "ccw" ? 1 : -1;
    if (directionName_ == "ccw" || (directionName_ == "cw" && sdf.child("turningDirection") != nullptr)) return;
    const Element* element = sdf.child("turningDirection");
    diagnostics.warning(element != nullptr ? element->position : sdf.position,
                        element != nullptr ? "<turningDirection> is '" + directionName_ + "': 'cw' is used"
                                           : "a rotor without a <turningDirection> turns clockwise",
                        "it can be 'cw' or 'ccw'");
  }

  void warnOfOddValues(const Element& sdf, Diagnostics& diagnostics) const {
    if (actuator_ < 0 && sdf.child("motorNumber") == nullptr) {
      diagnostics.warning(sdf.position, "a rotor without an <actuator_number> has the number 0",
                          "for Fortress it is <motorNumber>");
    }
    for (const auto& [name, value] : {std::pair("motorConstant", motorConstant_),
                                      {"momentConstant", momentConstant_},
                                      {"rotorDragCoefficient", dragCoefficient_},
                                      {"rollingMomentCoefficient", rollingCoefficient_}}) {
      if (value >= 0) continue;
      diagnostics.warning(sdf.child(name)->position,
                          "<" + std::string(name) + "> is negative: its force or torque acts in the wrong direction");
    }
  }

  void receive(const ignition::msgs::Actuators& message) {
    // a command from a system of the model takes precedence
    if (model_->actuators() != nullptr) return;
    if (number_ >= message.velocity_size()) return complainOfLength(message.velocity_size());
    follow(message.velocity(number_));
  }

  void take(const std::vector<double>& told) {
    if (static_cast<std::size_t>(number_) >= told.size()) return complainOfLength(static_cast<int>(told.size()));
    follow(told[static_cast<std::size_t>(number_)]);
  }

  void follow(double speed) {
    if (speed >= -kFastestRotor) {
      reference_ = std::min({speed, maximum_, kFastestRotor});
    } else if (!std::exchange(hasWarnedOfCommand_, true)) {
      log_->warning("a rotor speed of " + std::to_string(speed) + " rad/s was ignored");
    }
  }

  void complainOfLength(int size) {
    if (std::exchange(hasWarnedOfCommand_, true)) return;
    log_->warning("a command of " + std::to_string(size) + " rotor speeds has no value for motor " +
                  std::to_string(number_) + " and was ignored");
  }

  void warnOfAliasing(double dt) {
    if (hasWarnedOfAliasing_ || std::abs(joint_->velocity()) * dt <= std::numbers::pi) return;
    hasWarnedOfAliasing_ = true;
    log_->warning("motor " + std::to_string(number_) +
                  " turns by more than half a turn in a step: a shorter step or a larger <rotorVelocitySlowdownSim> "
                  "is needed");
  }

  /// Drag and rolling moment of the rotor, proportional to its speed and its lateral airspeed. P. Martin and E. Salaun,
  /// The True Role of Accelerometer Feedback in Quadrotor Control, ICRA 2010.
  /// @param speed Of the rotor about the joint's axis [rad/s].
  void applyForces(double speed) {
    if (speed == 0) return;
    const Quaternion rotation = link_->pose().rotation;
    const double thrust = direction_ * std::copysign(speed * speed, speed) * motorConstant_;
    const Vector3 axis = rotation * axis_;
    const Vector3 velocity = link_->linearVelocity() - world_->wind();
    const Vector3 across = std::abs(speed) * (velocity - velocity.dot(axis) * axis);
    const Vector3 force = rotation * Vector3(0, 0, thrust) - dragCoefficient_ * across;
    link_->addWrench(force, (rotation * center_).cross(force));
    parent_->addWrench(Vector3::Zero(),
                       rotation * Vector3(0, 0, -direction_ * thrust * momentConstant_) - rollingCoefficient_ * across);
  }

  std::string nameSpace_, jointName_, linkName_, commandTopic_, speedTopic_;
  std::string directionName_ = "cw";
  std::string type_ = "velocity";
  int actuator_ = -1;
  int number_ = 0;
  double maximum_ = 838;
  double motorConstant_ = 8.54858e-6;
  double momentConstant_ = 0.016;
  double dragCoefficient_ = 1e-4;
  double rollingCoefficient_ = 1e-6;
  double timeUp_ = 1.0 / 80;
  double timeDown_ = 1.0 / 40;
  double slowdown_ = 10;

  const Logger* log_ = nullptr;
  World* world_ = nullptr;
  std::optional<Model> model_;
  std::optional<Joint> joint_;
  std::optional<Link> link_;
  std::optional<Link> parent_;
  /// Of the link's mass, link frame.
  Vector3 center_ = Vector3::Zero();
  /// Of the joint, link frame.
  Vector3 axis_ = Vector3::UnitZ();
  /// 1 anticlockwise, -1 clockwise.
  double direction_ = -1;
  FirstOrderFilter filter_;
  /// Commanded speed in the turning direction [rad/s].
  double reference_ = 0;
  bool hasWarnedOfCommand_ = false;
  bool hasWarnedOfAliasing_ = false;
  Subscription command_;
  Publisher speed_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::MulticopterMotorModel, "ignition::gazebo::systems::MulticopterMotorModel",
                      "gz::sim::systems::MulticopterMotorModel");
