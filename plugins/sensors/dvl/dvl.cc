#include <ignition/msgs/dvl_velocity_tracking.pb.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dvl_settings.hh"
#include "dvl_tracking.hh"
#include "pongsim/parameters.hh"
#include "pongsim/sensing/beam_scene.hh"
#include "pongsim/sensing/environment.hh"
#include "pongsim/sensing/sensor_system.hh"

namespace pongsim {

namespace {

using ignition::msgs::DVLBeamState;
using ignition::msgs::DVLKinematicEstimate;
using ignition::msgs::DVLTrackingTarget;
using ignition::msgs::DVLVelocityTracking;
using When = DvlSettings::When;

constexpr const char* kType = "dvl";
constexpr const char* kSuffix = "/dvl/velocity";
constexpr const char* kMessageType = "ignition.msgs.DVLVelocityTracking";
// about as many as the largest lidars have
constexpr std::size_t kMostRays = 100'000;
constexpr std::uint32_t kEverything = 0xFFFFFFFF;

/// What all DVLs of a world share.
struct Surroundings {
  explicit Surroundings(const World& seen, const Logger& logger) : world(seen), log(logger), scene(seen) {}

  /// @return The scene with the poses of this step.
  BeamScene& now() {
    if (!std::exchange(isCurrent, true)) scene.update();
    return scene;
  }

  World world;
  const Logger& log;
  BeamScene scene;
  bool isCurrent = false;
  const Environment* environment = nullptr;
  std::uint64_t version = 0;
};

/// What a beam hits.
struct Target {
  /// [m]; infinite without a hit.
  double range = std::numeric_limits<double>::infinity();
  /// World frame [m, m/s].
  Vector3 position = Vector3::Zero();
  Vector3 velocity = Vector3::Zero();
};

/// What a DVL tracks, before it is a message.
struct Tracking {
  VelocityFit fit;
  std::optional<VelocityFit::Result> result;
  /// Of a beam's speed [m^2/s^2].
  double speedVariance = 0;

  /// @return Variance of the velocity; infinite without one.
  double variance() const {
    return result ? speedVariance * result->covariance.trace() : std::numeric_limits<double>::infinity();
  }
};

void setEstimate(const Vector3& mean, const Matrix3& covariance, DVLKinematicEstimate& estimate) {
  estimate.set_reference(DVLKinematicEstimate::DVL_REFERENCE_SHIP);
  setVector(mean, *estimate.mutable_mean());
  estimate.mutable_covariance()->Resize(9, 0);
  for (int i = 0; i < 9; ++i) estimate.set_covariance(i, covariance(i / 3, i % 3));
}

double varianceOf(const NoiseSettings& noise) {
  return noise.type == NoiseSettings::Type::kNone ? 0 : noise.standardDeviation * noise.standardDeviation;
}

class DvlSensor final : public SensorOf<DVLVelocityTracking> {
 public:
  DvlSensor(const SensorContext& context, Surroundings& surroundings)
      : SensorOf(context),
        sensor_(context.sensor),
        settings_(readDvl(sensor_.sdf())),
        surroundings_(surroundings),
        bottomNoise_(context.noises.add(settings_.bottom.noise, "bottom")),
        waterNoise_(context.noises.add(settings_.water.noise, "water")),
        second_(context.advertise(SensorReadings::kMessage)),
        secondMessage_(message()) {
    for (const DvlBeam& beam : settings_.beams) {
      if (countOf(beam) > kMostRays) tooManyRays();
      const std::vector<Vector3> rays = raysOf(beam, settings_.resolution);
      rays_.insert(rays_.end(), rays.begin(), rays.end());
      ends_.push_back(rays_.size());
      if (rays_.size() > kMostRays) tooManyRays();
    }
    echoes_.resize(rays_.size());
    links_.resize(rays_.size());
    targets_.resize(settings_.beams.size());
  }

  void observe(const StepInfo& info) override { now_ = info.time; }

  bool isReady() override { return settings_.bottom.when != When::kNever || settings_.water.when != When::kNever; }

  void measure() override {
    findTargets();
    const Tracking bottom = settings_.bottom.when == When::kNever ? Tracking() : trackBottom(bottom_);
    const Tracking water = settings_.water.when == When::kNever ? Tracking() : trackWater(water_);
    const bool prefersBottom = isBetter(bottom, water);
    const bool showsBottom = isShown(settings_.bottom.when, prefersBottom, settings_.water.when);
    const bool showsWater = isShown(settings_.water.when, !prefersBottom, settings_.bottom.when);
    fillIn(showsBottom ? bottom_ : water_, message());
    hasSecond_ = showsBottom && showsWater;
    if (hasSecond_) fillIn(water_, secondMessage_);
  }

  void publishElsewhere() override {
    if (!hasSecond_) return;
    *secondMessage_.mutable_header() = message().header();
    second_.publish(secondMessage_);
  }

 private:
  /// @return About the number of a beam's rays.
  double countOf(const DvlBeam& beam) const {
    const double rings = beam.aperture / 2 / settings_.resolution;
    return 1 + 3 * rings * rings;
  }

  [[noreturn]] void tooManyRays() const {
    refuse(sensor_.sdf(), "sensor '" + sensor_.scopedName() + "' has more than " + std::to_string(kMostRays) + " rays",
           "their number grows with the <aperture> of the beams and falls with the <resolution>");
  }

  /// @param isPreferred Whether this mode is more certain than the other.
  static bool isShown(When when, bool isPreferred, When other) {
    return when == When::kAlways || (when == When::kBest && (isPreferred || other == When::kNever));
  }

  static bool isBetter(const Tracking& bottom, const Tracking& water) {
    if (bottom.result || water.result) return bottom.variance() <= water.variance();
    return bottom.fit.beams() >= water.fit.beams();
  }

  static void fillIn(const DVLVelocityTracking& from, DVLVelocityTracking& to) {
    // all but its header
    to.set_type(from.type());
    *to.mutable_beams() = from.beams();
    to.clear_target();
    to.clear_velocity();
    if (from.has_target()) *to.mutable_target() = from.target();
    if (from.has_velocity()) *to.mutable_velocity() = from.velocity();
  }

  /// Finds the nearest point in the cone of each beam.
  void findTargets() {
    surroundings_.now().cast(sensor_, rays_, settings_.minRange, settings_.maxRange, kEverything, echoes_, links_);
    const Pose X_WorldSensor = sensor_.pose();
    std::size_t ray = 0;
    for (std::size_t beam = 0; beam < targets_.size(); ++beam) {
      std::size_t nearest = ray;
      for (; ray < ends_[beam]; ++ray) {
        if (rangeOf(ray) < rangeOf(nearest)) nearest = ray;
      }
      Target& target = targets_[beam];
      target = {};
      target.range = rangeOf(nearest);
      if (!std::isfinite(target.range)) continue;
      target.position = X_WorldSensor.position + X_WorldSensor.rotation * (target.range * rays_[nearest]);
      if (!links_[nearest]) continue;
      const std::optional<Link> link = surroundings_.world.link(*links_[nearest]);
      if (!link) continue;
      target.velocity = link->linearVelocity() + link->angularVelocity().cross(target.position - link->pose().position);
    }
  }

  /// @return Infinite for a ray that hits nothing, or something too close.
  double rangeOf(std::size_t ray) const {
    const double range = echoes_[ray].range;
    return range > 0 ? range : std::numeric_limits<double>::infinity();
  }

  /// Empties a message.
  void begin(DVLVelocityTracking& tracking) const {
    tracking.Clear();
    tracking.set_type(settings_.type == DvlSettings::Type::kPiston ? DVLVelocityTracking::DVL_TYPE_PISTON
                                                                   : DVLVelocityTracking::DVL_TYPE_PHASED_ARRAY);
  }

  /// Adds a beam's speed to a message and to the fit.
  void addSpeed(const Vector3& axis, double speed, double variance, DVLBeamState& state, VelocityFit& fit) const {
    const Vector3 shown = settings_.toReference * axis;
    setEstimate(shown * speed, variance * shown * shown.transpose(), *state.mutable_velocity());
    state.set_locked(true);
    fit.add(shown, speed);
  }

  void finish(DVLTrackingTarget::TargetType type, double range, double rangeVariance, Tracking& tracking,
              DVLVelocityTracking& shown) const {
    tracking.result = tracking.fit.solve();
    if (tracking.result) {
      setEstimate(tracking.result->velocity, tracking.speedVariance * tracking.result->covariance,
                  *shown.mutable_velocity());
    }
    if (tracking.fit.beams() == 0) return;
    shown.mutable_target()->set_type(type);
    shown.mutable_target()->mutable_range()->set_mean(range);
    shown.mutable_target()->mutable_range()->set_variance(rangeVariance);
  }

  Tracking trackBottom(DVLVelocityTracking& shown) {
    begin(shown);
    Tracking tracking;
    tracking.speedVariance = varianceOf(settings_.bottom.noise);
    const Quaternion R_SensorWorld = sensor_.pose().rotation.conjugate();
    const Vector3 velocity = sensor_.linearVelocity();
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      DVLBeamState& state = *shown.add_beams();
      state.set_id(settings_.beams[i].id);
      if (!std::isfinite(targets_[i].range)) continue;
      state.mutable_range()->set_mean(targets_[i].range);
      nearest = std::min(nearest, targets_[i].range);
      const Vector3& axis = settings_.beams[i].axis;
      const double speed = bottomNoise_.apply((R_SensorWorld * (velocity - targets_[i].velocity)).dot(axis));
      addSpeed(axis, speed, tracking.speedVariance, state, tracking.fit);
    }
    finish(DVLTrackingTarget::DVL_TARGET_BOTTOM, nearest, 0, tracking, shown);
    return tracking;
  }

  Tracking trackWater(DVLVelocityTracking& shown) {
    begin(shown);
    Tracking tracking;
    tracking.speedVariance = varianceOf(settings_.water.noise);
    if (!knowsWater()) return tracking;
    double nearest = std::numeric_limits<double>::infinity(), rangeVariance = 0;
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      DVLBeamState& state = *shown.add_beams();
      state.set_id(settings_.beams[i].id);
      const Vector3& axis = settings_.beams[i].axis;
      // only a beam that reaches through the whole layer counts
      if (targets_[i].range * -axis.z() < settings_.far) continue;
      const double scale = 1 / -axis.z(), height = scale * (settings_.far - settings_.near);
      const double range = scale * (settings_.far + settings_.near) / 2;
      // of a uniform distribution
      const double variance = height * height / 12;
      state.mutable_range()->set_mean(range);
      state.mutable_range()->set_variance(variance);
      if (range < nearest) rangeVariance = variance;
      nearest = std::min(nearest, range);
      const RunningVariance speeds = waterSpeeds(axis);
      addSpeed(axis, speeds.mean(), speeds.variance(), state, tracking.fit);
    }
    finish(DVLTrackingTarget::DVL_TARGET_WATER_MASS, nearest, rangeVariance, tracking, shown);
    return tracking;
  }

  /// @return The speeds relative to the water in the middle of each of its layers, along a beam.
  RunningVariance waterSpeeds(const Vector3& axis) {
    const Pose X_WorldSensor = sensor_.pose();
    const Vector3 velocity = sensor_.linearVelocity();
    const double height = (settings_.far - settings_.near) / settings_.bins;
    RunningVariance speeds;
    for (int bin = 0; bin < settings_.bins; ++bin) {
      const double depth = settings_.near + height * (bin + 0.5);
      const Vector3 point = X_WorldSensor.position + X_WorldSensor.rotation * (depth / -axis.z() * axis);
      const Vector3 relative = X_WorldSensor.rotation.conjugate() * (velocity - waterAt(point));
      speeds.add(waterNoise_.apply(relative.dot(axis)));
    }
    return speeds;
  }

  /// @return Velocity of the water, world frame [m/s]; zero where it is not known, as in Gazebo.
  Vector3 waterAt(const Vector3& point) const {
    Vector3 velocity = Vector3::Zero();
    const Environment& environment = *surroundings_.environment;
    const std::optional<Vector3> place = environment.placeOf(point, surroundings_.world);
    for (std::size_t axis = 0; place && axis < 3; ++axis) {
      if (!quantities_[axis]) continue;
      velocity[static_cast<Eigen::Index>(axis)] = environment.at(*quantities_[axis], now_, *place).value_or(0);
    }
    return velocity;
  }

  /// @return Whether the environment has the velocity of the water.
  bool knowsWater() {
    const Environment* environment = surroundings_.environment;
    if (environment == nullptr) return warnOnce("the world has no environment, which EnvironmentPreload reads");
    if (known_ == surroundings_.version) return isKnown_;
    known_ = surroundings_.version;
    isKnown_ = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string& name = settings_.waterVelocity[axis];
      quantities_[axis] = environment->quantity(name);
      if (!quantities_[axis] && !name.empty()) isKnown_ = warnOnce("the environment has no '" + name + "'");
    }
    return isKnown_;
  }

  bool warnOnce(const std::string& why) {
    if (!std::exchange(hasWarned_, true)) {
      surroundings_.log.warning("sensor '" + sensor_.scopedName() + "' can't track water: " + why);
    }
    return false;
  }

  Sensor sensor_;
  DvlSettings settings_;
  Surroundings& surroundings_;
  Noise& bottomNoise_;
  Noise& waterNoise_;
  Time now_{0};
  /// Of all beams, in the sensor frame.
  std::vector<Vector3> rays_;
  /// For each beam, the end of its rays.
  std::vector<std::size_t> ends_;
  std::vector<Echo> echoes_;
  std::vector<std::optional<LinkId>> links_;
  std::vector<Target> targets_;
  DVLVelocityTracking bottom_;
  DVLVelocityTracking water_;
  /// Of both modes at once, on the same topic.
  bool hasSecond_ = false;
  Publisher second_;
  DVLVelocityTracking secondMessage_;
  std::array<std::optional<std::size_t>, 3> quantities_;
  /// Version of the environment in which they were looked up.
  std::uint64_t known_ = 0;
  bool isKnown_ = false;
  bool hasWarned_ = false;
};

class DopplerVelocityLogSystem final : public SensorSystem, public EnvironmentUser {
 public:
  DopplerVelocityLogSystem()
      : SensorSystem({{.sensorType = kType,
                       .kind = SensorReadings::kMessage,
                       .suffix = kSuffix,
                       .behind = {},
                       .messageType = kMessageType}}) {}

  void declare(Declaration& declaration) override {
    declaration.is("Publishes the readings of Doppler velocity logs (DVL).", Declaration::Place::kWorld);
    declaration.publishes(std::string("/world/W/model/M/link/L/sensor/S") + kSuffix, kMessageType,
                          "one per sensor with `type=\"custom\" gz:type=\"dvl\"`; `<topic>` in the `<sensor>` renames "
                          "it, `<update_rate>` sets its rate");
    SensorSystem::declare(declaration);
  }

  void configure(const SystemContext& context) override {
    shareEnvironment(context.before);
    log_ = &context.log;
    SensorSystem::configure(context);
  }

  void postUpdate(const StepInfo& info) override {
    if (surroundings_) {
      surroundings_->isCurrent = false;
      surroundings_->environment = environment();
      surroundings_->version = environmentVersion();
    }
    SensorSystem::postUpdate(info);
  }

 protected:
  void rebuild(Diagnostics& diagnostics) override {
    if (!surroundings_) return;
    surroundings_->scene.rebuild(diagnostics);
    surroundings_->isCurrent = false;
  }

  std::unique_ptr<SensorDevice> make(const SensorContext& context) override {
    // made with the first sensor, because Embree is loaded then
    if (!surroundings_) {
      surroundings_ = std::make_unique<Surroundings>(context.world, *log_);
      surroundings_->scene.rebuild(context.diagnostics);
    }
    return std::make_unique<DvlSensor>(context, *surroundings_);
  }

 private:
  const Logger* log_ = nullptr;
  std::unique_ptr<Surroundings> surroundings_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::DopplerVelocityLogSystem, "gz::sim::systems::DopplerVelocityLogSystem",
                      "ignition::gazebo::systems::DopplerVelocityLogSystem");
