#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/odometry.pb.h>
#include <ignition/msgs/pose_v.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "odometry.hh"
#include "pongsim/system.hh"
#include "speed_limiter.hh"

namespace pongsim {

namespace {

[[noreturn]] void fail(const Element& where, std::string message, std::string hint = {}) {
  throw Error({Severity::kError, where.position, std::move(message), std::move(hint)});
}

/// Reads a length that must be more than zero [m].
double readLength(const Element& sdf, std::string_view name, double fallback) {
  const double length = sdf.get(name, fallback);
  if (!(length > 0) || !std::isfinite(length)) {
    fail(*sdf.child(name), "<" + std::string(name) + "> must be a length above zero");
  }
  return length;
}

/// @return The joints that the elements of that name ask for.
std::vector<Joint> findJoints(const Element& sdf, const Model& model, std::string_view elementName) {
  std::vector<Joint> joints;
  for (const Element* element : sdf.childrenNamed(elementName)) {
    const std::optional<Joint> joint = model.joint(element->text);
    const std::string subject = "<" + element->name + "> '" + element->text + "'";
    if (!joint) {
      std::string names;
      for (const Joint& other : model.joints()) names += (names.empty() ? "" : ", ") + std::string(other.name());
      fail(*element, subject + " is no joint of model '" + std::string(model.name()) + "'",
           names.empty() ? "the model has no joints" : "its joints are " + names);
    }
    if (joint->axisCount() == 0) fail(*element, subject + " is a joint without an axis that could be driven");
    joints.push_back(*joint);
  }
  if (joints.empty()) fail(sdf, "no <" + std::string(elementName) + "> is given");
  return joints;
}

/// Reads the limits of linear or angular motion: `<max_velocity>` for both, `<max_linear_velocity>` for one.
SpeedLimits readLimits(const Element& sdf, const std::string& kind) {
  const auto read = [&](const std::string& bound, const std::string& quantity, double fallback) {
    return sdf.get(bound + "_" + kind + "_" + quantity, sdf.get(bound + "_" + quantity, fallback));
  };
  SpeedLimits limits;
  const auto readPair = [&](const std::string& quantity, double& min, double& max) {
    min = read("min", quantity, min);
    max = read("max", quantity, max);
    if (!(min <= max)) fail(sdf, "the smallest " + kind + " " + quantity + " is above the largest");
  };
  readPair("velocity", limits.minVelocity, limits.maxVelocity);
  readPair("acceleration", limits.minAcceleration, limits.maxAcceleration);
  readPair("jerk", limits.minJerk, limits.maxJerk);
  return limits;
}

/// Fills in the stamp and the two frame names that stand in a header's data.
void setHeader(Time stamp, const std::string& frame, const std::string& childFrame, ignition::msgs::Header& header) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(stamp);
  header.mutable_stamp()->set_sec(seconds.count());
  header.mutable_stamp()->set_nsec(static_cast<std::int32_t>((stamp - seconds).count()));
  if (header.data_size() > 0) return;
  const auto add = [&](const char* key, const std::string& value) {
    ignition::msgs::Header::Map& entry = *header.add_data();
    entry.set_key(key);
    entry.add_value(value);
  };
  add("frame_id", frame);
  add("child_frame_id", childFrame);
}

/// Drives the wheels of a differential drive as a Twist commands, and publishes where it believes to be.
class DiffDrive : public System {
 public:
  void configure(const SystemContext& context) override {
    log_ = &context.log;
    if (!context.model) fail(context.sdf, "DiffDrive must stand in a <model>");
    const Element& sdf = context.sdf;
    const Model& model = *context.model;
    leftJoints_ = findJoints(sdf, model, "left_joint");
    rightJoints_ = findJoints(sdf, model, "right_joint");
    separation_ = readLength(sdf, "wheel_separation", 1.0);
    radius_ = readLength(sdf, "wheel_radius", 0.2);
    odometry_.emplace(separation_, radius_);
    linearLimiter_ = SpeedLimiter(readLimits(sdf, "linear"));
    angularLimiter_ = SpeedLimiter(readLimits(sdf, "angular"));

    const double frequency = sdf.get("odom_publish_frequency", 50.0);
    if (frequency > 0) publishPeriod_ = fromSeconds(std::min(1 / frequency, 1e9));

    const std::string name(model.name());
    frame_ = sdf.get<std::string>("frame_id", name + "/odom");
    childFrame_ = sdf.get<std::string>("child_frame_id", name + "/" + std::string(model.canonicalLink()->name()));
    openTopics(sdf, cleanTopic("/model/" + name), context.node);
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    const double dt = toSeconds(info.dt);
    const double linear = linearLimiter_.limit(targetLinear_, dt);
    const double angular = angularLimiter_.limit(targetAngular_, dt);
    for (Joint& joint : leftJoints_) joint.setVelocityTarget((linear - angular * separation_ / 2) / radius_);
    for (Joint& joint : rightJoints_) joint.setVelocityTarget((linear + angular * separation_ / 2) / radius_);
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused) return;
    odometry_->update(leftJoints_.front().position(), rightJoints_.front().position(), toSeconds(info.dt));
    if (info.time - lastPublished_ < publishPeriod_) return;
    lastPublished_ = info.time;
    if (odometryPublisher_.hasSubscribers()) publishOdometry(info.time);
    if (tfPublisher_.hasSubscribers()) publishTf(info.time);
  }

  void reset() override {
    odometry_->reset();
    linearLimiter_.reset();
    angularLimiter_.reset();
    targetLinear_ = targetAngular_ = 0;
    enabled_ = true;
    lastPublished_ = Time::zero();
  }

  void transfer(StateArchive& archive) override {
    odometry_->transfer(archive);
    linearLimiter_.transfer(archive);
    angularLimiter_.transfer(archive);
    archive(targetLinear_);
    archive(targetAngular_);
    archive(enabled_);
    archive(lastPublished_);
  }

 private:
  void openTopics(const Element& sdf, const std::string& prefix, Node& node) {
    const auto topic = [&](std::string_view parameter, const char* fallback) {
      return sdf.get<std::string>(parameter, prefix + fallback);
    };
    command_ = node.subscribe<ignition::msgs::Twist>(cleanTopic(topic("topic", "/cmd_vel")),
                                                     [this](const ignition::msgs::Twist& twist) { receive(twist); });
    enable_ = node.subscribe<ignition::msgs::Boolean>(
        prefix + "/enable", [this](const ignition::msgs::Boolean& message) { setEnabled(message.data()); });
    odometryPublisher_ = node.advertise<ignition::msgs::Odometry>(cleanTopic(topic("odom_topic", "/odometry")));
    tfPublisher_ = node.advertise<ignition::msgs::Pose_V>(topic("tf_topic", "/tf"));
  }

  void receive(const ignition::msgs::Twist& twist) {
    if (!enabled_) return;
    const double linear = twist.linear().x();
    const double angular = twist.angular().z();
    if (!std::isfinite(linear) || !std::isfinite(angular)) {
      log_->warning("a command that is not finite was ignored");
      return;
    }
    targetLinear_ = linear;
    targetAngular_ = angular;
  }

  void setEnabled(bool enabled) {
    enabled_ = enabled;
    if (!enabled) targetLinear_ = targetAngular_ = 0;
  }

  void publishOdometry(Time time) {
    setHeader(time, frame_, childFrame_, *odometryMessage_.mutable_header());
    setPose(*odometryMessage_.mutable_pose());
    odometryMessage_.mutable_twist()->mutable_linear()->set_x(odometry_->linearVelocity());
    odometryMessage_.mutable_twist()->mutable_angular()->set_z(odometry_->angularVelocity());
    odometryPublisher_.publish(odometryMessage_);
  }

  void publishTf(Time time) {
    if (tfMessage_.pose_size() == 0) tfMessage_.add_pose();
    ignition::msgs::Pose& pose = *tfMessage_.mutable_pose(0);
    setHeader(time, frame_, childFrame_, *pose.mutable_header());
    setPose(pose);
    tfPublisher_.publish(tfMessage_);
  }

  void setPose(ignition::msgs::Pose& pose) const {
    pose.mutable_position()->set_x(odometry_->x());
    pose.mutable_position()->set_y(odometry_->y());
    pose.mutable_orientation()->set_z(std::sin(odometry_->heading() / 2));
    pose.mutable_orientation()->set_w(std::cos(odometry_->heading() / 2));
  }

  std::vector<Joint> leftJoints_;
  std::vector<Joint> rightJoints_;
  double separation_ = 1;
  double radius_ = 0.2;
  Time publishPeriod_{0};
  Time lastPublished_{0};
  std::string frame_;
  std::string childFrame_;

  double targetLinear_ = 0;
  double targetAngular_ = 0;
  bool enabled_ = true;
  SpeedLimiter linearLimiter_;
  SpeedLimiter angularLimiter_;
  std::optional<Odometry> odometry_;

  const Logger* log_ = nullptr;
  Publisher odometryPublisher_;
  Publisher tfPublisher_;
  Subscription command_;
  Subscription enable_;
  ignition::msgs::Odometry odometryMessage_;
  ignition::msgs::Pose_V tfMessage_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::DiffDrive, "ignition::gazebo::systems::DiffDrive", "gz::sim::systems::DiffDrive");
