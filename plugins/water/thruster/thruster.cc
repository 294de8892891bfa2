#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/double.pb.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/battery.hh"
#include "pongsim/commands.hh"
#include "pongsim/control/pid.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"
#include "propeller.hh"

namespace pongsim {

namespace {

constexpr double kMostThrust = 1000;
/// Below this error of the speed the controller is off [rad/s].
constexpr double kNearEnough = 0.1;

/// Applies a commanded thrust at a propeller, and spins it accordingly.
class Thruster : public System {
 public:
  void declare(Declaration& declaration) override;
  void configure(const SystemContext& context) override;
  void preUpdate(const StepInfo& info) override;

  void reset() override {
    thrust_ = 0;
    hasDeadband_ = deadband_.has_value();
    propeller_.reset();
    pid_.reset();
  }

  void transfer(StateArchive& archive) override {
    archive(thrust_);
    archive(hasDeadband_);
    archive(propeller_);
    archive(pid_);
  }

 private:
  void checkSettings(const SystemContext& context);
  void connectBattery();
  void listen(Node& node, const std::string& modelName);
  void receive(double command);
  void tell(double speed, double thrust);

  std::string jointName_;
  std::string namespace_;
  std::string topic_;
  PropellerSettings settings_;
  PidSettings gains_{.p = 0.1, .iMin = -1, .iMax = 1};
  bool isDrivenDirectly_ = false;
  /// Commands are speeds [rad/s] instead of thrusts [N].
  bool isToldSpeeds_ = false;
  /// Of the command.
  double least_ = -kMostThrust;
  double most_ = kMostThrust;
  std::optional<double> deadband_;
  std::optional<double> powerLoad_;
  std::string batteryName_;

  std::optional<Model> model_;
  std::optional<Batteries> batteries_;
  /// Looked up late, because batteries come with systems that may be configured later.
  bool isConnected_ = false;
  std::optional<Joint> joint_;
  std::optional<Link> link_;
  /// Axis of the joint in the link frame, the direction of thrust.
  Vector3 axis_ = Vector3::UnitX();
  double thrust_ = 0;
  Propeller propeller_;
  Pid pid_;

  const Logger* log_ = nullptr;
  bool hasDeadband_ = false;
  Subscription commands_;
  Subscription positions_;
  Subscription deadbands_;
  /// Of the speed, or of the thrust if commands are speeds.
  Publisher feedback_;
};

void Thruster::declare(Declaration& declaration) {
  declaration.is("Applies a commanded thrust at a propeller, and spins it accordingly.", Declaration::Place::kModel);
  declaration.parameter("joint_name", &jointName_, "", "joint of the propeller").required();
  declaration.parameter("namespace", &namespace_, "", "replaces the model's name in the topics").otherwise("M");
  declaration.parameter("topic", &topic_, "", "the command topic is `NAMESPACE/TOPIC`, and the others follow from it")
      .otherwise("/model/NAMESPACE/joint/J/cmd_thrust, with use_angvel_cmd .../cmd_vel");
  declaration.parameter("use_angvel_cmd", &isToldSpeeds_, "", "the command is the propeller's speed [rad/s]");
  declaration.parameter("fluid_density", &settings_.density, "kg/m^3", "density of the fluid").above(0);
  declaration.parameter("propeller_diameter", &settings_.diameter, "m", "diameter of the propeller").above(0);
  declaration
      .parameter("thrust_coefficient", &settings_.coefficient, "",
                 "thrust = fluid_density * thrust_coefficient * propeller_diameter^4 * (speed in rad/s)^2")
      .otherwise("from alpha_1 and alpha_2");
  declaration.parameter("alpha_1", &settings_.alpha1, "", "thrust coefficient of a craft at rest");
  declaration.parameter("alpha_2", &settings_.alpha2, "",
                        "change with (1 - wake_fraction) * craft's speed / (speed * propeller_diameter)");
  declaration.parameter("wake_fraction", &settings_.wakeFraction, "",
                        "relative reduction of the water speed at the propeller");
  declaration.parameter("max_thrust_cmd", &most_, "N or rad/s", "maximum thrust, or speed; limit of the command");
  declaration.parameter("min_thrust_cmd", &least_, "N or rad/s", "minimum thrust, or speed");
  declaration.parameter("deadband", &deadband_, "N", "a thrust below it is none").atLeast(0).otherwise("none");
  declaration.parameter("velocity_control", &isDrivenDirectly_, "",
                        "drives the joint at the speed; otherwise a PID controller applies torques");
  declaration.parameter("p_gain", &gains_.p, "N m s/rad", "proportional gain of that controller");
  declaration.parameter("i_gain", &gains_.i, "N m/rad", "integral gain");
  declaration.parameter("d_gain", &gains_.d, "N m s^2/rad", "derivative gain");
  declaration.parameter("power_load", &powerLoad_, "W", "power drawn from a battery, independent of thrust");
  declaration.parameter("battery_name", &batteryName_, "", "name of the battery, in any model").otherwise("none");
  declaration.subscribes("<topic>", "ignition.msgs.Double", "thrust [N], which holds until the next command");
  declaration.subscribes("<topic>", "ignition.msgs.Double", "with `<use_angvel_cmd>`: speed of the propeller [rad/s]");
  declaration.subscribes("/model/NAMESPACE/joint/J/cmd_pos", "ignition.msgs.Double",
                         "the same as `cmd_thrust`, in older worlds");
  declaration.subscribes("/model/NAMESPACE/joint/J/enable_deadband", "ignition.msgs.Boolean",
                         "whether there is the deadband; `<topic>/enable_deadband` with that parameter");
  declaration.publishes("/model/NAMESPACE/joint/J/ang_vel", "ignition.msgs.Double",
                        "speed of the propeller [rad/s], in each step; `<topic>/ang_vel` with that parameter");
  declaration.sharesTopics();
  declaration.publishes("/model/NAMESPACE/joint/J/force", "ignition.msgs.Double",
                        "with `<use_angvel_cmd>`, thrust [N], in place of `ang_vel`; `<topic>/force` likewise");
}

void Thruster::configure(const SystemContext& context) {
  log_ = &context.log;
  model_ = context.model;
  batteries_ = Batteries(context.world);
  joint_ = requiredJoint(context.sdf, "joint_name", *context.model);
  link_ = joint_->child();
  axis_ = joint_->poseInChild().rotation * joint_->axisInfo().xyz;
  checkSettings(context);
  propeller_ = Propeller(settings_);
  gains_.commandMax = propeller_.speedFor(most_);
  gains_.commandMin = propeller_.speedFor(least_);
  pid_ = Pid(gains_);
  listen(context.node, std::string(context.model->name()));
}

void Thruster::checkSettings(const SystemContext& context) {
  const Element& sdf = context.sdf;
  if (settings_.coefficient == 0) refuse(*sdf.child("thrust_coefficient"), "<thrust_coefficient> must not be zero");
  if (most_ < least_) {
    const Element* element = sdf.child("max_thrust_cmd");
    if (element == nullptr) element = sdf.child("min_thrust_cmd");
    context.diagnostics.warning(element->position,
                                "<max_thrust_cmd> is below <min_thrust_cmd>: 1000 and -1000 N are used");
    most_ = kMostThrust;
    least_ = -kMostThrust;
  }
  if (powerLoad_ && batteryName_.empty()) {
    context.diagnostics.warning(sdf.child("power_load")->position,
                                "<power_load> has no effect: no <battery_name> is given");
  }
  for (const char* name : {"alpha_1", "alpha_2", "wake_fraction"}) {
    const Element* element = sdf.child(name);
    if (element == nullptr || !settings_.coefficient) continue;
    context.diagnostics.warning(element->position,
                                std::string("<") + name + "> has no effect: <thrust_coefficient> is given too");
  }
}

void Thruster::listen(Node& node, const std::string& modelName) {
  const std::string robot = namespace_.empty() ? modelName : namespace_;
  const std::string joint = "/model/" + robot + "/joint/" + std::string(joint_->name());
  const std::string prefix = topic_.empty() ? joint : robot + "/" + topic_;
  const auto subscribe = [&](const std::string& topic) {
    return node.subscribe<ignition::msgs::Double>(
        cleanTopic(topic), [this](const ignition::msgs::Double& message) { receive(message.data()); }, kForces);
  };
  const std::string command = joint + (isToldSpeeds_ ? "/cmd_vel" : "/cmd_thrust");
  commands_ = subscribe(topic_.empty() ? command : prefix);
  if (!isToldSpeeds_) positions_ = subscribe(joint + "/cmd_pos");
  deadbands_ = node.subscribe<ignition::msgs::Boolean>(
      cleanTopic(prefix + "/enable_deadband"),
      [this](const ignition::msgs::Boolean& message) { hasDeadband_ = message.data(); });
  hasDeadband_ = deadband_.has_value();
  feedback_ = node.advertise<ignition::msgs::Double>(cleanTopic(prefix + (isToldSpeeds_ ? "/force" : "/ang_vel")));
}

void Thruster::receive(double command) {
  command = std::clamp(command, least_, most_);
  thrust_ = isToldSpeeds_ ? propeller_.thrustAt(command) : command;
  propeller_.turnFor(thrust_);
}

void Thruster::tell(double speed, double thrust) {
  if (!feedback_.hasSubscribers()) return;
  ignition::msgs::Double message;
  message.set_data(isToldSpeeds_ ? thrust : speed);
  feedback_.publish(message);
}

/// Reports once the power drawn from its battery.
void Thruster::connectBattery() {
  isConnected_ = true;
  if (batteryName_.empty() || !powerLoad_) return;
  std::vector<Battery> named = batteries_->named(batteryName_);
  if (named.size() == 1) {
    named.front().setLoad("thruster of " + model_->scopedName() + "::" + std::string(joint_->name()), *powerLoad_);
  } else {
    log_->warning("draws no power from battery '" + batteryName_ + "': there " +
                  (named.empty() ? "is none of that name" : "are several of that name"));
  }
}

void Thruster::preUpdate(const StepInfo& info) {
  if (info.paused) return;
  if (!isConnected_) connectBattery();
  if (batteries_->areEmpty(*model_)) return;
  const Vector3 axis = link_->pose().rotation * axis_;
  double target = propeller_.turnFor(thrust_);
  double thrust = thrust_;
  if (hasDeadband_ && std::abs(thrust) < deadband_.value_or(0)) thrust = target = 0;
  double speed = target;
  double torque = 0;
  if (isDrivenDirectly_) {
    joint_->setVelocityTarget(target);
  } else {
    speed = link_->angularVelocity().dot(axis);
    if (std::abs(speed - target) > kNearEnough) torque = pid_.update(speed - target, toSeconds(info.dt));
  }
  link_->addWrench(thrust * axis, torque * axis);
  tell(speed, thrust);
  propeller_.setCraftSpeed(link_->linearVelocity().norm());
}

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::Thruster, "ignition::gazebo::systems::Thruster", "gz::sim::systems::Thruster");
