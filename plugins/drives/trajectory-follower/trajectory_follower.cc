#include <ignition/msgs/boolean.pb.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "path.hh"
#include "pongsim/math.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Pushes a model along waypoints: turns it towards the next one, then pushes it ahead.
class TrajectoryFollower : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Pushes a model along waypoints: turns it towards the next one, then pushes it ahead.",
                   Declaration::Place::kModel);
    declaration.parameter("link_name", &linkName_, "", "link that is pushed along x and turned about z").required();
    declaration.element("waypoints", "the points to visit: `<waypoint>` x y [m], world frame");
    declaration.element("circle", "instead of waypoints: eight points around the start, at a `<radius>` [m]");
    declaration.element("line",
                        "instead of both: the start and a point in a `<direction>` [rad] from the link's x axis, at a "
                        "`<length>` [m]");
    declaration.parameter("loop", &loops_, "", "continues with the first point after the last");
    declaration.parameter("force", &force_, "N", "forward force").atLeast(0);
    declaration.parameter("torque", &torque_, "N m", "turning torque").atLeast(0);
    declaration.parameter("range_tolerance", &rangeTolerance_, "m", "a point is reached within this distance")
        .atLeast(0);
    declaration.parameter("bearing_tolerance", &bearingTolerance_, "degrees", "it faces a point within this angle")
        .atLeast(0);
    declaration.parameter("zero_vel_on_bearing_reached", &stopsTurning_, "",
                          "it stops turning at half of that angle, and turns again beyond that angle");
    declaration.parameter("topic", &topic_, "", "pauses it").otherwise("/model/M/trajectory_follower/pause");
    declaration.subscribes("<topic>", "ignition.msgs.Boolean", "`true` pauses, `false` resumes");
  }

  void configure(const SystemContext& context) override {
    model_ = context.model;
    link_ = requiredLink(context.sdf, "link_name", *model_);
    axes_ = link_->mass().axes;
    path_ = Path::read(context.sdf, context.diagnostics);
    const std::string fallback = "/model/" + std::string(model_->name()) + "/trajectory_follower/pause";
    pause_ = context.node.subscribe<ignition::msgs::Boolean>(
        topicOr(topic_, fallback), [this](const auto& message) { isPaused_ = message.data(); });
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    if (!isPaused_) follow();
    // all points of a model that does not turn have the same velocity
    if (keepsHeading_) model_->setVelocity(link_->linearVelocity(), Vector3::Zero());
  }

  void reset() override {
    points_.clear();
    next_ = 0;
    isPaused_ = keepsHeading_ = false;
  }

  void transfer(StateArchive& archive) override {
    archive(points_);
    archive(next_);
    archive.check(next_ < std::max<std::size_t>(points_.size(), 1));
    archive(isPaused_);
    archive(keepsHeading_);
  }

 private:
  void follow() {
    const Pose X_WorldLink = link_->pose();
    // the path starts where the link is when it may first move
    if (points_.empty()) points_ = path_.points(X_WorldLink);
    Vector3 way = points_[next_] - X_WorldLink.position;
    way.z() = 0;
    const Vector3 ahead = X_WorldLink.rotation.conjugate() * way;
    if (ahead.stableNorm() <= rangeTolerance_) return goToNext();

    const double bearing = math::atan2(ahead.y(), ahead.x()) / kDegree;
    const Quaternion axes = X_WorldLink.rotation * axes_;
    if (std::abs(bearing) > bearingTolerance_) {
      keepsHeading_ = false;
      link_->addWrench(Vector3::Zero(), axes * Vector3(0, 0, std::copysign(torque_, bearing)));
    } else {
      if (stopsTurning_ && std::abs(bearing) <= bearingTolerance_ / 2) keepsHeading_ = true;
      link_->addWrench(axes * Vector3(force_, 0, 0), Vector3::Zero());
    }
  }

  /// The last point stays the target if none follows: a link that drifts away returns.
  void goToNext() {
    if (next_ + 1 < points_.size()) {
      ++next_;
    } else if (loops_) {
      next_ = 0;
    }
  }

  std::string linkName_, topic_;
  bool loops_ = false;
  double force_ = 60;
  double torque_ = 50;
  double rangeTolerance_ = 0.5;
  double bearingTolerance_ = 2;
  bool stopsTurning_ = false;

  std::optional<Model> model_;
  std::optional<Link> link_;
  /// Axes of the link's inertia, link frame: the force is along the x axis.
  Quaternion axes_ = Quaternion::Identity();
  Path path_;
  /// World frame; empty before the start.
  std::vector<Vector3> points_;
  std::size_t next_ = 0;
  bool isPaused_ = false;
  /// The link must not turn.
  bool keepsHeading_ = false;
  Subscription pause_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::TrajectoryFollower, "ignition::gazebo::systems::TrajectoryFollower",
                      "gz::sim::systems::TrajectoryFollower");
