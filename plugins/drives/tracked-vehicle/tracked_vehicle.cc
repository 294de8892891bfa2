#include <ignition/msgs/double.pb.h>
#include <ignition/msgs/twist.pb.h>
#include <ignition/msgs/vector3d.pb.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "pongsim/commands.hh"
#include "pongsim/control/differential_odometry.hh"
#include "pongsim/control/odometry_topics.hh"
#include "pongsim/control/speed_limiter.hh"
#include "pongsim/geometry/surface_motion.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Below these the vehicle drives straight on [rad/s], or turns on the spot [m/s].
constexpr double kSlowestTurn = 0.1;
constexpr double kSlowestDrive = 0.1;
/// Smaller changes of velocity are ignored [m/s, rad/s].
constexpr double kSmallestChange = 1e-6;

/// Commands the tracks of a vehicle from Twists, and publishes its odometry.
class TrackedVehicle : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is(
        "Drives a tracked vehicle by Twist commands, and publishes its odometry. Each track needs a TrackController.",
        Declaration::Place::kModel);
    const char* const track =
        "a track: its `link` and, if they differ from TrackController's defaults, `velocity_topic` and "
        "`center_of_rotation_topic`; may be repeated";
    declaration.element("left_track", track).required();
    declaration.element("right_track", track).required();
    declaration.parameter("body_link", &bodyName_, "", "link about whose origin the vehicle turns, with y to the left")
        .otherwise("the canonical link");
    declaration.parameter("tracks_separation", &separation_, "m", "distance between left and right tracks").above(0);
    declaration.parameter("track_height", &height_, "m", "height of the tracks; no effect on odometry").above(0);
    declaration.parameter("tracks_height", &height_, "m", "the same, spelled as in Fortress's own worlds").above(0);
    declaration
        .parameter("steering_efficiency", &initialEfficiency_, "", "ratio of the vehicle's rotation to the ideal one")
        .above(0);
    const char* const limits =
        "holds `min_velocity`, `max_velocity`, and likewise `_acceleration` and `_jerk`, of the vehicle";
    declaration.element("linear_velocity", limits);
    declaration.element("angular_velocity", limits);
    declaration.parameter("topic", &topic_, "", "command topic").otherwise("/model/M/cmd_vel");
    declaration.parameter("steering_efficiency_topic", &efficiencyTopic_, "", "topic for steering efficiencies")
        .otherwise("/model/M/steering_efficiency");
    odometryTopics_.declare(declaration);
    declaration.parameter("debug", &debug_, "", "logs the tracks' commands (`-v 4`)");
    declaration.subscribes("<topic>", "ignition.msgs.Twist",
                           "`linear.x` [m/s] and `angular.z` [rad/s], which hold until the next command");
    declaration.subscribes("<steering_efficiency_topic>", "ignition.msgs.Double", "a new steering efficiency, above 0");
    declaration.publishes("<velocity_topic>", "ignition.msgs.Double", "speed of a track [m/s], when it changes");
    declaration.publishes("<center_of_rotation_topic>", "ignition.msgs.Vector3d",
                          "centre of rotation in the world [m]; infinite for straight motion");
  }

  void configure(const SystemContext& context) override {
    log_ = &context.log;
    const Element& sdf = context.sdf;
    const Model& model = *context.model;
    const std::string prefix = "/model/" + std::string(model.name());
    body_ = bodyName_.empty() ? model.canonicalLink() : std::optional(requiredLink(sdf, "body_link", model));
    openTracks("left_track", context, left_);
    openTracks("right_track", context, right_);
    linearLimiter_ = SpeedLimiter(limitsIn(sdf, "linear_velocity", "linear"));
    angularLimiter_ = SpeedLimiter(limitsIn(sdf, "angular_velocity", "angular"));
    efficiency_ = initialEfficiency_;
    odometry_.emplace(separation_, 1);
    command_ = context.node.subscribe<ignition::msgs::Twist>(
        topicOr(topic_, prefix + "/cmd_vel"), [this](const ignition::msgs::Twist& twist) { receive(twist); },
        kCommands);
    efficiencies_ = context.node.subscribe<ignition::msgs::Double>(
        topicOr(efficiencyTopic_, prefix + "/steering_efficiency"),
        [this](const ignition::msgs::Double& message) { receiveEfficiency(message.data()); }, kCommands);
    odometryTopics_.open(model, context.node, body_);
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    const double dt = toSeconds(info.dt);
    const double linear = linearLimiter_.limit(targetLinear_, dt);
    const double angular = angularLimiter_.limit(targetAngular_, dt);
    const bool changes = std::abs(linear - linear_) > kSmallestChange || std::abs(angular - angular_) > kSmallestChange;
    linear_ = linear;
    angular_ = angular;
    if (isNew_ || changes) tellTracks();
    isNew_ = false;
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused) return;
    const double dt = toSeconds(info.dt);
    leftWay_ += leftSpeed_ * dt;
    rightWay_ += rightSpeed_ * dt;
    odometry_->update(leftWay_, rightWay_, dt);
    odometryTopics_.update(odometry_->value(), info.time);
  }

  void reset() override {
    odometry_->reset();
    odometryTopics_.reset();
    linearLimiter_.reset();
    angularLimiter_.reset();
    for (double* value : remembered()) *value = 0;
    efficiency_ = initialEfficiency_;
    isNew_ = false;
  }

  void transfer(StateArchive& archive) override {
    odometry_->transfer(archive);
    odometryTopics_.transfer(archive);
    linearLimiter_.transfer(archive);
    angularLimiter_.transfer(archive);
    for (double* value : remembered()) archive(*value);
    archive(efficiency_);
    archive(isNew_);
  }

 private:
  struct Track {
    Publisher speed;
    Publisher center;
  };

  std::vector<double*> remembered() {
    return {&targetLinear_, &targetAngular_, &linear_, &angular_, &leftSpeed_, &rightSpeed_, &leftWay_, &rightWay_};
  }

  /// Warns of errors in one of several tracks, and continues without that one.
  static void openTracks(const char* side, const SystemContext& context, std::vector<Track>& tracks) {
    const Model& model = *context.model;
    const std::vector<const Element*> elements = context.sdf.childrenNamed(side);
    for (const Element* element : elements) {
      try {
        const std::string link(requiredLink(*element, "link", model).name());
        const std::string prefix = "/model/" + std::string(model.name()) + "/link/" + link;
        const auto topic = [&](const char* name, const std::string& fallback) {
          return topicOr(element->get<std::string>(name, ""), prefix + fallback);
        };
        tracks.push_back({context.node.advertise<ignition::msgs::Double>(topic("velocity_topic", "/track_cmd_vel")),
                          context.node.advertise<ignition::msgs::Vector3d>(
                              topic("center_of_rotation_topic", "/track_cmd_center_of_rotation"))});
      } catch (const Error& error) {
        if (elements.size() == 1) throw;
        const Diagnostic& diagnostic = error.diagnostic();
        context.diagnostics.warning(
            diagnostic.position, "a <" + std::string(side) + "> is left out: " + diagnostic.message, diagnostic.hint);
      }
    }
    if (tracks.empty()) refuse(context.sdf, "none of the <" + std::string(side) + "> is there");
  }

  static SpeedLimits limitsIn(const Element& sdf, const char* name, const char* kind) {
    const Element* holder = sdf.child(name);
    if (holder == nullptr) return {};
    const auto value = [holder](const char* quantity) { return holder->find<double>(quantity); };
    const SpeedLimitParameters limits{value("min_velocity"),     value("max_velocity"), value("min_acceleration"),
                                      value("max_acceleration"), value("min_jerk"),     value("max_jerk")};
    return speedLimits(limits, {}, kind, *holder);
  }

  void receive(const ignition::msgs::Twist& twist) {
    const double linear = twist.linear().x();
    const double angular = twist.angular().z();
    const double fastest = std::abs(linear) + std::abs(angular) * separation_ / (2 * efficiency_);
    if (!(fastest <= SurfaceMotion::kLargestSpeed)) {
      log_->warning("a command was ignored: a track would run faster than 1e6 m/s");
      return;
    }
    targetLinear_ = linear;
    targetAngular_ = angular;
    isNew_ = true;
  }

  void receiveEfficiency(double efficiency) {
    const double fastest = std::abs(targetLinear_) + std::abs(targetAngular_) * separation_ / (2 * efficiency);
    if (!(efficiency > 0) || !(fastest <= SurfaceMotion::kLargestSpeed)) {
      log_->warning(
          "a steering efficiency was ignored: it must be above zero, and no track may run faster than 1e6 m/s");
      return;
    }
    efficiency_ = efficiency;
    isNew_ = true;
  }

  void tellTracks() {
    const double difference = angular_ * separation_ / (2 * efficiency_);
    leftSpeed_ = linear_ - difference;
    rightSpeed_ = linear_ + difference;
    const Vector3 center = centerOfRotation();
    ignition::msgs::Vector3d centerMessage;
    centerMessage.set_x(center.x());
    centerMessage.set_y(center.y());
    centerMessage.set_z(center.z());
    const auto tell = [&](std::vector<Track>& tracks, double speed) {
      ignition::msgs::Double speedMessage;
      speedMessage.set_data(speed);
      for (Track& track : tracks) {
        track.speed.publish(speedMessage);
        track.center.publish(centerMessage);
      }
    };
    tell(left_, leftSpeed_);
    tell(right_, rightSpeed_);
    if (!debug_) return;
    std::ostringstream text;
    text << "at " << linear_ << " m/s and " << angular_ << " rad/s the left tracks get " << leftSpeed_
         << " m/s and the right ones " << rightSpeed_ << " m/s, about " << center.transpose();
    log_->debug(text.str());
  }

  /// @return In the world frame; infinite for straight motion.
  Vector3 centerOfRotation() const {
    if (std::abs(angular_) < kSlowestTurn) return Vector3::Constant(std::numeric_limits<double>::infinity());
    const double radius = std::abs(linear_) < kSlowestDrive ? 0 : linear_ / angular_;
    return body_->pose() * Vector3(0, radius, 0);
  }

  std::string bodyName_;
  double separation_ = 1;
  double height_ = 0.2;
  double initialEfficiency_ = 0.5;
  std::string topic_, efficiencyTopic_;
  bool debug_ = false;

  std::optional<Link> body_;
  std::vector<Track> left_, right_;
  double targetLinear_ = 0;
  double targetAngular_ = 0;
  double efficiency_ = 0.5;
  /// Whether the tracks need a command although the velocities are unchanged.
  bool isNew_ = false;
  /// After the limits.
  double linear_ = 0;
  double angular_ = 0;
  double leftSpeed_ = 0;
  double rightSpeed_ = 0;
  /// Distance that the tracks have run [m].
  double leftWay_ = 0;
  double rightWay_ = 0;
  SpeedLimiter linearLimiter_;
  SpeedLimiter angularLimiter_;
  std::optional<DifferentialOdometry> odometry_;

  const Logger* log_ = nullptr;
  OdometryTopics odometryTopics_;
  Subscription command_, efficiencies_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::TrackedVehicle, "ignition::gazebo::systems::TrackedVehicle",
                      "gz::sim::systems::TrackedVehicle");
