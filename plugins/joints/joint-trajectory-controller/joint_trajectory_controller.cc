#include <ignition/msgs/float.pb.h>
#include <ignition/msgs/joint_trajectory.pb.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/commands.hh"
#include "pongsim/control/pid.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"
#include "trajectory.hh"

namespace pongsim {

namespace {

/// Settings of the position or the velocity controllers: one value per joint, in the order of the joints.
struct PidLists {
  std::vector<double> p, i, d, iMin, iMax, commandMin, commandMax, commandOffset;

  void declare(Declaration& declaration, const std::string& prefix, const char* what) {
    const std::string of = std::string(" of the ") + what + " controller, for each joint";
    const auto add = [&](const char* name, std::vector<double>& values, const char* text, const char* fallback) {
      declaration.parameter(prefix + name, &values, "", text + of).otherwise(fallback);
    };
    add("_p_gain", p, "proportional gain", "0");
    add("_i_gain", i, "integral gain", "0");
    add("_d_gain", d, "derivative gain", "0");
    add("_i_min", iMin, "minimum integral term", "0");
    add("_i_max", iMax, "maximum integral term", "-1, no bounds");
    add("_cmd_min", commandMin, "minimum force", "0");
    add("_cmd_max", commandMax, "maximum force", "-1, no bounds");
    add("_cmd_offset", commandOffset, "offset added to the force", "0");
  }

  PidSettings of(std::size_t joint) const {
    PidSettings settings;
    const auto take = [joint](const std::vector<double>& values, double& value) {
      if (joint < values.size()) value = values[joint];
    };
    take(p, settings.p);
    take(i, settings.i);
    take(d, settings.d);
    take(iMin, settings.iMin);
    take(iMax, settings.iMax);
    take(commandMin, settings.commandMin);
    take(commandMax, settings.commandMax);
    take(commandOffset, settings.commandOffset);
    return settings;
  }
};

/// A joint with its target and controllers.
class ControlledJoint {
 public:
  ControlledJoint(const Joint& joint, double initialPosition, const PidSettings& position, const PidSettings& velocity)
      : joint_(joint),
        initial_{.position = initialPosition},
        target_(initial_),
        position_(position),
        velocity_(velocity) {}

  std::string_view name() const { return joint_.name(); }
  JointTarget& target() { return target_; }

  void push(double dt) {
    joint_.addForce(position_.update(joint_.position() - target_.position, dt) +
                    velocity_.update(joint_.velocity() - target_.velocity, dt) + target_.effort);
  }

  void resetControllers() {
    position_.reset();
    velocity_.reset();
  }

  void reset() {
    resetControllers();
    target_ = initial_;
  }

  void transfer(StateArchive& archive) {
    archive(target_);
    archive(position_);
    archive(velocity_);
  }

 private:
  Joint joint_;
  JointTarget initial_;
  JointTarget target_;
  Pid position_;
  Pid velocity_;
};

/// Moves joints along the points of a trajectory.
class JointTrajectoryController : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Moves the joints of a model along the points of a trajectory.", Declaration::Place::kModel);
    declaration.parameter("joint_name", &jointNames_, "", "joints of the model, with one axis each")
        .otherwise("all with one axis");
    declaration.parameter("topic", &topic_, "", "topic of trajectories").otherwise("/model/M/joint_trajectory");
    declaration.parameter("initial_position", &initialPositions_, "rad or m", "initial position of each joint")
        .otherwise("0");
    positionPid_.declare(declaration, "position", "position");
    velocityPid_.declare(declaration, "velocity", "velocity");
    declaration.subscribes("<topic>", "ignition.msgs.JointTrajectory",
                           "replaces the previous one; positions, velocities and efforts are used");
    declaration.publishes("<topic>_progress", "ignition.msgs.Float", "fraction of points begun, at each point");
  }

  void configure(const SystemContext& context) override {
    const Model& model = *context.model;
    log_ = &context.log;
    for (const Joint& joint : jointsOf(context)) {
      const std::size_t number = joints_.size();
      const double initial = number < initialPositions_.size() ? initialPositions_[number] : 0;
      joints_.emplace_back(joint, initial, positionPid_.of(number), velocityPid_.of(number));
    }
    if (joints_.empty()) refuse(context.sdf, "model '" + std::string(model.name()) + "' has no joint with one axis");
    // it is an attribute in Fortress, too
    usesHeaderTime_ = context.sdf.attributeOr("use_header_start_time", "false") == "true";
    const std::string topic = topicOr(topic_, "/model/" + std::string(model.name()) + "/joint_trajectory");
    command_ = context.node.subscribe<ignition::msgs::JointTrajectory>(
        topic, [this](const ignition::msgs::JointTrajectory& message) { receive(message); }, kCommands);
    progress_ = context.node.advertise<ignition::msgs::Float>(topic + "_progress");
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    begin(info.time);
    if (trajectory_ && trajectory_->advance(info.time)) {
      for (std::size_t i = 0; i < active_.size(); ++i) trajectory_->target(i, active_[i]->target());
      if (progress_.hasSubscribers()) {
        ignition::msgs::Float message;
        message.set_data(static_cast<float>(trajectory_->progress()));
        progress_.publish(message);
      }
    }
    for (ControlledJoint& joint : joints_) joint.push(toSeconds(info.dt));
  }

  void reset() override {
    waiting_.reset();
    trajectory_.reset();
    active_.clear();
    for (ControlledJoint& joint : joints_) joint.reset();
  }

  void transfer(StateArchive& archive) override {
    std::string waiting = waiting_ ? waiting_->SerializeAsString() : "";
    archive(waiting);
    archive(trajectory_);
    for (ControlledJoint& joint : joints_) archive(joint);
    if (!archive.isGiving()) return;
    waiting_.reset();
    if (!waiting.empty()) archive.check(waiting_.emplace().ParseFromString(waiting) && !fault(*waiting_));
    findActive();
    archive.check(std::ranges::find(active_, nullptr) == active_.end());
  }

 private:
  std::vector<Joint> jointsOf(const SystemContext& context) const {
    if (!jointNames_.empty()) return requiredJoints(context.sdf, "joint_name", *context.model);
    std::vector<Joint> joints = context.model->joints();
    std::erase_if(joints, [](const Joint& joint) { return joint.axisCount() != 1; });
    return joints;
  }

  /// @return What is wrong with a trajectory, or nothing.
  std::optional<std::string> fault(const ignition::msgs::JointTrajectory& message) {
    if (auto fault = Trajectory::fault(message)) return fault;
    for (const std::string& name : message.joint_names()) {
      if (find(name) == nullptr) return "joint '" + name + "' is not controlled";
    }
    return std::nullopt;
  }

  void receive(const ignition::msgs::JointTrajectory& message) {
    if (const auto found = fault(message)) return log_->warning("a trajectory was ignored: " + *found);
    if (std::ranges::any_of(message.points(), [](const auto& point) { return point.accelerations_size() > 0; })) {
      log_->warning("accelerations of a trajectory are ignored, as in Fortress");
    }
    waiting_ = message;
  }

  /// Starts a trajectory received since the last step.
  void begin(Time now) {
    if (!waiting_) return;
    const bool hasTime = usesHeaderTime_ && waiting_->has_header() && waiting_->header().has_stamp();
    const auto& stamp = waiting_->header().stamp();
    const Time start = hasTime ? std::chrono::seconds(stamp.sec()) + std::chrono::nanoseconds(stamp.nsec()) : now;
    trajectory_.emplace(*waiting_, start);
    waiting_.reset();
    findActive();
    for (ControlledJoint& joint : joints_) joint.resetControllers();
  }

  void findActive() {
    active_.clear();
    if (!trajectory_) return;
    for (const std::string& name : trajectory_->joints()) active_.push_back(find(name));
  }

  ControlledJoint* find(const std::string& name) {
    const auto found = std::ranges::find(joints_, name, &ControlledJoint::name);
    return found != joints_.end() ? &*found : nullptr;
  }

  std::vector<std::string> jointNames_;
  std::string topic_;
  std::vector<double> initialPositions_;
  PidLists positionPid_, velocityPid_;
  bool usesHeaderTime_ = false;

  std::vector<ControlledJoint> joints_;
  /// The trajectory's joints, in its order.
  std::vector<ControlledJoint*> active_;
  std::optional<Trajectory> trajectory_;
  std::optional<ignition::msgs::JointTrajectory> waiting_;
  const Logger* log_ = nullptr;
  Subscription command_;
  Publisher progress_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::JointTrajectoryController, "ignition::gazebo::systems::JointTrajectoryController",
                      "gz::sim::systems::JointTrajectoryController");
