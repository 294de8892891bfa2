#include <ignition/msgs/double.pb.h>
#include <ignition/msgs/odometry.pb.h>
#include <ignition/msgs/vector3d.pb.h>

#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "pongsim/commands.hh"
#include "pongsim/control/speed_limiter.hh"
#include "pongsim/geometry/surface_motion.hh"
#include "pongsim/messages/fields.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// With a centre of rotation farther away, the track moves straight [m].
constexpr double kFarthestCenter = 1e9;

/// Moves the surface of a link at a commanded speed, like a vehicle's track or a conveyor belt.
class TrackController : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Moves the surface of a link at a commanded speed, like a vehicle's track or a conveyor belt.",
                   Declaration::Place::kModel);
    declaration.parameter("link", &linkName_, "", "the track, or the belt").required();
    declaration.parameter("track_orientation", &orientation_, "rad",
                          "roll, pitch and yaw of the track in the link: at positive speed its top moves "
                          "along its x axis");
    declaration.parameter("velocity_topic", &velocityTopic_, "", "topic of speeds")
        .otherwise("/model/M/link/L/track_cmd_vel");
    declaration.parameter("center_of_rotation_topic", &centerTopic_, "", "topic of centres of rotation")
        .otherwise("/model/M/link/L/track_cmd_center_of_rotation");
    declaration.parameter("max_command_age", &maxAge_, "s", "time without commands after which the track stops")
        .atLeast(0)
        .mayBeInfinite()
        .otherwise("none");
    declareTrackLimits(declaration);
    declaration.parameter("odometry_topic", &odometryTopic_, "", "topic of the track's own motion")
        .otherwise("/model/M/link/L/odometry");
    declaration.parameter("odometry_publish_frequency", &odometryRate_, "Hz",
                          "messages per simulated second; 0: one per step");
    declaration.parameter("debug", &debug_, "", "logs commands and motion (`-v 4`)");
    declaration.subscribes("<velocity_topic>", "ignition.msgs.Double", "speed [m/s], which holds until the next one");
    declaration.subscribes("<center_of_rotation_topic>", "ignition.msgs.Vector3d",
                           "centre of rotation in the world [m]; not finite: straight motion");
    declaration.publishes("<odometry_topic>", "ignition.msgs.Odometry",
                          "distance that the track has run, `pose.position.x` [m], and speed, `twist.linear.x` [m/s]");
  }

  void configure(const SystemContext& context) override {
    log_ = &context.log;
    const Model& model = *context.model;
    const Link link = requiredLink(context.sdf, "link", model);
    collisions_ = link.collisions();
    if (collisions_.empty()) {
      context.diagnostics.warning(context.sdf.child("link")->position,
                                  "<link> '" + linkName_ + "' has no <collision>: it moves nothing");
    }
    axis_ = fromRollPitchYaw(orientation_.x(), orientation_.y(), orientation_.z()) * Vector3::UnitY();
    limiter_ = SpeedLimiter(speedLimits(limits_, {}, "track", context.sdf));
    const std::string prefix = "/model/" + std::string(model.name()) + "/link/" + linkName_;
    velocity_ = context.node.subscribe<ignition::msgs::Double>(
        topicOr(velocityTopic_, prefix + "/track_cmd_vel"),
        [this](const ignition::msgs::Double& message) { receiveSpeed(message.data()); }, kCommands);
    centers_ = context.node.subscribe<ignition::msgs::Vector3d>(
        topicOr(centerTopic_, prefix + "/track_cmd_center_of_rotation"),
        [this](const ignition::msgs::Vector3d& message) {
          receiveCenter({message.x(), message.y(), message.z()});
        });
    odometry_ = context.node.advertise<ignition::msgs::Odometry>(topicOr(odometryTopic_, prefix + "/odometry"));
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    if (isNew_) lastCommand_ = info.time;
    isNew_ = false;
    const bool isOld = maxAge_ && toSeconds(info.time - lastCommand_) > *maxAge_;
    const double speed = limiter_.limit(isOld ? 0 : wanted_, toSeconds(info.dt));
    speed_ = speed;
    position_ += speed * toSeconds(info.dt);
    const SurfaceMotion motion{.speed = speed, .axis = axis_, .center = center_};
    if (motion_ == motion) return;
    motion_ = motion;
    for (Collision& collision : collisions_) collision.setSurfaceMotion(motion);
    if (debug_) tell();
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused || info.time - lastOdometry_ < periodOf(odometryRate_)) return;
    lastOdometry_ = info.time;
    if (!odometry_.hasSubscribers()) return;
    ignition::msgs::Odometry message;
    setStamp(info.time, *message.mutable_header());
    message.mutable_pose()->mutable_position()->set_x(position_);
    message.mutable_twist()->mutable_linear()->set_x(speed_);
    odometry_.publish(message);
  }

  void reset() override {
    limiter_.reset();
    lastOdometry_ = Time::zero();
    position_ = speed_ = 0;
    wanted_ = 0;
    center_.reset();
    lastCommand_ = Time::zero();
    isNew_ = false;
    motion_.reset();
  }

  void transfer(StateArchive& archive) override {
    limiter_.transfer(archive);
    archive(lastOdometry_);
    archive(position_);
    archive(speed_);
    archive(wanted_);
    archive(center_);
    archive(lastCommand_);
    archive(isNew_);
    // it is part of the collisions' own state
    if (archive.isGiving()) motion_.reset();
  }

 private:
  void declareTrackLimits(Declaration& declaration) {
    const auto add = [&](const char* quantity, const char* unit, std::optional<double>& min,
                         std::optional<double>& max) {
      const std::string name(quantity);
      declaration.parameter("min_" + name, &min, unit, "minimum " + name + " of the track")
          .mayBeInfinite()
          .otherwise("no limit");
      declaration.parameter("max_" + name, &max, unit, "maximum " + name + " of the track")
          .mayBeInfinite()
          .otherwise("no limit");
    };
    add("velocity", "m/s", limits_.minVelocity, limits_.maxVelocity);
    add("acceleration", "m/s^2", limits_.minAcceleration, limits_.maxAcceleration);
    add("jerk", "m/s^3", limits_.minJerk, limits_.maxJerk);
  }

  void receiveSpeed(double speed) {
    wanted_ = speed;
    isNew_ = true;
  }

  void receiveCenter(const Vector3& center) {
    // values that are not finite are Fortress's encoding of straight motion
    const bool isNear = center.cwiseAbs().maxCoeff() <= kFarthestCenter && center.allFinite();
    center_ = isNear ? std::optional(center) : std::nullopt;
    isNew_ = true;
  }

  void tell() const {
    std::ostringstream text;
    text << "'" << linkName_ << "' is commanded to run at " << wanted_ << " m/s and runs at " << motion_->speed
         << " m/s, ";
    if (center_) {
      text << "about " << center_->x() << " " << center_->y() << " " << center_->z();
    } else {
      text << "straight on";
    }
    log_->debug(text.str());
  }

  std::string linkName_;
  Vector3 orientation_ = Vector3::Zero();
  std::string velocityTopic_, centerTopic_, odometryTopic_;
  double odometryRate_ = 50;
  std::optional<double> maxAge_;
  SpeedLimitParameters limits_;
  bool debug_ = false;

  std::vector<Collision> collisions_;
  /// Axis of the track's drums, in the link frame.
  Vector3 axis_ = Vector3::UnitY();
  double wanted_ = 0;
  std::optional<Vector3> center_;
  Time lastCommand_{0};
  bool isNew_ = false;
  SpeedLimiter limiter_;
  /// Distance run [m], and speed [m/s].
  double position_ = 0;
  double speed_ = 0;
  Time lastOdometry_{0};
  /// Last command to the collisions.
  std::optional<SurfaceMotion> motion_;

  const Logger* log_ = nullptr;
  Subscription velocity_, centers_;
  Publisher odometry_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::TrackController, "ignition::gazebo::systems::TrackController",
                      "gz::sim::systems::TrackController");
