#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lee_velocity_controller.hh"
#include "pongsim/commands.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"
#include "rotors.hh"

namespace pongsim {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Adds mass and inertia of the links of a model and its nested models. As in Fortress, the links' poses in the model
/// are ignored.
void addMass(const Model& model, std::vector<MassInfo>& masses) {
  for (const Link& link : model.links()) masses.push_back(link.mass());
  for (const Model& inner : model.models()) addMass(inner, masses);
}

VehicleMass massOf(const Model& model) {
  std::vector<MassInfo> masses;
  addMass(model, masses);
  VehicleMass vehicle;
  Vector3 center = Vector3::Zero();
  for (const MassInfo& part : masses) {
    vehicle.mass += part.mass;
    center += part.mass * part.center;
  }
  center /= vehicle.mass;
  for (const MassInfo& part : masses) {
    const Vector3 arm = part.center - center;
    vehicle.inertia += part.inertia + part.mass * (arm.squaredNorm() * Matrix3::Identity() - arm * arm.transpose());
  }
  return vehicle;
}

/// Flies a multicopter by Twist commands: computes its rotor speeds.
class MulticopterVelocityControl : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Flies a multicopter by Twist commands: computes its rotor speeds.", Declaration::Place::kModel);
    declaration.parameter("robotNamespace", &nameSpace_, "", "prefix of the topics").required();
    declaration.parameter("commandSubTopic", &commandTopic_, "", "command topic, in the namespace");
    declaration.parameter("enableSubTopic", &enableTopic_, "", "topic that switches it on and off, in the namespace");
    declaration.parameter("comLinkName", &bodyName_, "", "link whose velocity is controlled, in its own axes")
        .required();
    declaration.parameter("velocityGain", &gains_.velocity, "N s/m", "gain of the velocity error").required();
    declaration.parameter("attitudeGain", &gains_.attitude, "N m/rad", "gain of the attitude error").required();
    declaration.parameter("angularRateGain", &gains_.angularRate, "N m s/rad", "gain of the angular velocity error")
        .required();
    declaration.parameter("maximumLinearAcceleration", &gains_.maximumAcceleration, "m/s^2", "acceleration limit");
    declaration.parameter("maximumLinearVelocity", &maximumLinear_, "m/s", "limit of the command");
    declaration.parameter("maximumAngularVelocity", &maximumAngular_, "rad/s", "limit of the command");
    declaration.parameter("linearVelocityNoiseMean", &linearNoise_.mean, "m/s",
                          "mean of the noise on the velocity, if its deviation is given");
    declaration.parameter("linearVelocityNoiseStdDev", &linearNoise_.deviation, "m/s", "its standard deviation");
    declaration.parameter("angularVelocityNoiseMean", &angularNoise_.mean, "rad/s",
                          "mean of the noise on the angular velocity, if its deviation is given");
    declaration.parameter("angularVelocityNoiseStdDev", &angularNoise_.deviation, "rad/s", "its standard deviation");
    declaration
        .element("rotorConfiguration",
                 "the rotors in the order of their motor numbers: `<rotor>` with `<jointName>`, `<forceConstant>` [N "
                 "s^2/rad^2], `<momentConstant>` [m] and `<direction>` (1 anticlockwise, -1 clockwise)")
        .required();
    declaration.subscribes("/<robotNamespace>/<commandSubTopic>", "ignition.msgs.Twist",
                           "`linear` [m/s] and `angular.z` [rad/s] in the axes of the body, which hold until the next "
                           "command");
    declaration.subscribes("/<robotNamespace>/<enableSubTopic>", "ignition.msgs.Boolean",
                           "`false` stops the rotors and discards the command");
  }

  void configure(const SystemContext& context) override {
    world_ = &context.world;
    random_ = &context.random;
    model_ = context.model;
    body_ = requiredLink(context.sdf, "comLinkName", *model_);
    checkVectors(context.sdf);
    const Element& configuration = *context.sdf.child("rotorConfiguration");
    const std::vector<Rotor> rotors = readRotors(configuration, *model_, *body_);
    const Allocation allocation = allocationOf(rotors);
    if (const int rank = rankOf(allocation); rank < 4) {
      refuse(configuration,
             std::to_string(rotors.size()) +
                 " rotors like these can't control a body: of thrust and three torques, they can set only " +
                 std::to_string(rank) + " independently",
             "use at least four rotors in different places, turning in both directions");
    }
    controller_.emplace(gains_, massOf(*model_), allocation);
    speeds_.assign(rotors.size(), 0);
    model_->setActuators(speeds_);

    const std::string prefix = nameSpace_ + "/";
    commands_ = context.node.subscribe<ignition::msgs::Twist>(
        cleanTopic(prefix + commandTopic_), [this](const ignition::msgs::Twist& twist) { receive(twist); }, kCommands);
    enable_ = context.node.subscribe<ignition::msgs::Boolean>(
        cleanTopic(prefix + enableTopic_), [this](const auto& message) { isActive_ = message.data(); });
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    if (!isActive_) return stop();
    if (!command_) return;
    BodyMotion motion;
    motion.R_WorldBody = body_->pose().rotation.toRotationMatrix();
    motion.velocity = body_->linearVelocity();
    motion.angularVelocity = motion.R_WorldBody.transpose() * body_->angularVelocity();
    falsify(motion.velocity, linearNoise_);
    falsify(motion.angularVelocity, angularNoise_);
    const VelocityCommand limited{
        command_->linear.cwiseMin(maximumLinear_.cwiseAbs()).cwiseMax(-maximumLinear_.cwiseAbs()),
        std::clamp(command_->yawRate, -std::abs(maximumAngular_.z()), std::abs(maximumAngular_.z()))};
    controller_->compute(motion, limited, world_->gravity(), speeds_);
    model_->setActuators(speeds_);
  }

  void reset() override {
    isActive_ = true;
    command_.reset();
    std::ranges::fill(speeds_, 0);
    model_->setActuators(speeds_);
  }

  void transfer(StateArchive& archive) override {
    archive(isActive_);
    archive(command_);
    archive(speeds_);
  }

 private:
  struct Noise {
    Vector3 mean = Vector3::Zero();
    Vector3 deviation = Vector3::Zero();
  };

  struct Command {
    Vector3 linear = Vector3::Zero();
    double yawRate = 0;

    void transfer(StateArchive& archive) {
      archive(linear);
      archive(yawRate);
    }
  };

  void checkVectors(const Element& sdf) const {
    for (const auto& [name, value] : {std::pair("maximumLinearAcceleration", &gains_.maximumAcceleration),
                                      {"linearVelocityNoiseStdDev", &linearNoise_.deviation},
                                      {"angularVelocityNoiseStdDev", &angularNoise_.deviation}}) {
      if (!(value->array() >= 0).all()) {
        refuse(*sdf.child(name), "<" + std::string(name) + "> must be three numbers, zero or more");
      }
    }
  }

  void receive(const ignition::msgs::Twist& twist) {
    command_ = {{twist.linear().x(), twist.linear().y(), twist.linear().z()}, twist.angular().z()};
  }

  /// Stops the rotors once; later commands are followed after it is switched on again.
  void stop() {
    if (std::ranges::all_of(speeds_, [](double speed) { return speed == 0; })) return;
    std::ranges::fill(speeds_, 0);
    model_->setActuators(speeds_);
    command_.reset();
  }

  void falsify(Vector3& value, const Noise& noise) {
    for (int axis = 0; axis < 3; ++axis) {
      if (noise.deviation[axis] > 0) value[axis] += random_->normal(noise.mean[axis], noise.deviation[axis]);
    }
  }

  std::string nameSpace_, bodyName_;
  std::string commandTopic_ = "cmd_vel";
  std::string enableTopic_ = "enable";
  LeeGains gains_{Vector3::Zero(), Vector3::Zero(), Vector3::Zero(), Vector3::Constant(kInfinity)};
  Vector3 maximumLinear_ = Vector3::Constant(kInfinity);
  Vector3 maximumAngular_ = Vector3::Constant(kInfinity);
  Noise linearNoise_, angularNoise_;

  World* world_ = nullptr;
  Random* random_ = nullptr;
  std::optional<Model> model_;
  std::optional<Link> body_;
  std::optional<LeeVelocityController> controller_;
  bool isActive_ = true;
  std::optional<Command> command_;
  /// Last command to the rotors [rad/s].
  std::vector<double> speeds_;
  Subscription commands_;
  Subscription enable_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::MulticopterVelocityControl, "ignition::gazebo::systems::MulticopterVelocityControl",
                      "gz::sim::systems::MulticopterVelocityControl");
