#include <ignition/msgs/double.pb.h>
#include <ignition/msgs/vector3d.pb.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "pongsim/parameters.hh"
#include "pongsim/sensing/custom_type.hh"
#include "pongsim/sensing/environment.hh"
#include "pongsim/sensing/sensor_system.hh"

namespace pongsim {

namespace {

constexpr const char* kScalar = "environmental_sensor";
constexpr const char* kVector = "environmental_vector_sensor";
constexpr const char* kSuffix = "/environmental_sensor";

/// The world's environment, as sensors see it.
class Surrounding {
 public:
  Surrounding(const World& world, const Logger& log) : world_(world), log_(log) {}

  /// The environment may have been set since.
  void update(const Environment* environment, std::uint64_t version) {
    environment_ = environment;
    version_ = version;
  }

  const World& world() const { return world_; }
  const Logger& log() const { return log_; }
  const Environment* environment() const { return environment_; }
  std::uint64_t version() const { return version_; }

 private:
  World world_;
  const Logger& log_;
  const Environment* environment_ = nullptr;
  std::uint64_t version_ = 0;
};

/// Reads up to three quantities at the place of a sensor.
class Probe {
 public:
  /// @param names An empty one is zero.
  Probe(const Sensor& sensor, std::array<std::string, 3> names, const Surrounding& surrounding)
      : sensor_(sensor), names_(std::move(names)), surrounding_(surrounding) {}

  /// @return Whether the environment has the quantities.
  bool isOfUse() {
    const Environment* environment = surrounding_.environment();
    if (environment == nullptr) {
      warnOnce("the world has no environment, which EnvironmentPreload reads");
      return false;
    }
    if (known_ != surrounding_.version()) find(*environment);
    return isKnown_;
  }

  /// Call it if `isOfUse`.
  /// @return The values; nothing outside of the environment.
  std::optional<Vector3> read(Time now) {
    const Environment* environment = surrounding_.environment();
    const std::optional<Vector3> place = environment->placeOf(sensor_.pose().position, surrounding_.world());
    if (!place) {
      warnOnce("the world needs <spherical_coordinates>");
      return std::nullopt;
    }
    Vector3 values = Vector3::Zero();
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (!quantities_[i]) continue;
      const std::optional<double> value = environment->at(*quantities_[i], now, *place);
      if (!value) return std::nullopt;
      values[static_cast<Eigen::Index>(i)] = *value;
    }
    return values;
  }

 private:
  void find(const Environment& environment) {
    known_ = surrounding_.version();
    isKnown_ = true;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      quantities_[i] = environment.quantity(names_[i]);
      if (quantities_[i] || names_[i].empty()) continue;
      isKnown_ = false;
      std::string known;
      for (const std::string& each : environment.quantities()) known += (known.empty() ? "" : ", ") + each;
      warnOnce("the environment has no '" + names_[i] + "', but " + (known.empty() ? "nothing" : known));
    }
  }

  void warnOnce(const std::string& why) {
    if (std::exchange(hasWarned_, true)) return;
    surrounding_.log().warning("sensor '" + sensor_.scopedName() + "' measures nothing: " + why);
  }

  Sensor sensor_;
  std::array<std::string, 3> names_;
  const Surrounding& surrounding_;
  std::array<std::optional<std::size_t>, 3> quantities_;
  /// Version of the environment in which they were looked up.
  std::uint64_t known_ = 0;
  bool isKnown_ = false;
  bool hasWarned_ = false;
};

/// @return The quantity in the sensor's element, else that in its type.
std::string scalarName(const Sensor& sensor) {
  const std::string named = sensor.sdf().get<std::string>("environment_variable", "");
  if (!named.empty()) return named;
  const std::string_view type = customTypeOf(sensor.sdf());
  return std::string(type.substr(std::min(type.size(), type.find('/') + 1)));
}

std::array<std::string, 3> vectorNames(const Sensor& sensor) {
  const auto name = [&](const char* element) { return sensor.sdf().get<std::string>(element, ""); };
  return {name("environment_variable_x"), name("environment_variable_y"), name("environment_variable_z")};
}

/// One that publishes a `Reading`.
template <class Reading>
class EnvironmentalSensor : public SensorOf<Reading> {
 public:
  EnvironmentalSensor(const SensorContext& context, std::array<std::string, 3> names, const Surrounding& surrounding)
      : SensorOf<Reading>(context), topic_(context.topic), probe_(context.sensor, std::move(names), surrounding) {}

  void observe(const StepInfo& info) final { now_ = info.time; }
  bool isReady() final {
    if (!probe_.isOfUse()) return false;
    // it would not be published
    if (!topic_.hasSubscribers()) return true;
    const std::optional<Vector3> values = probe_.read(now_);
    values_ = values.value_or(Vector3::Zero());
    return values.has_value();
  }

 protected:
  const Vector3& values() const { return values_; }

 private:
  const SensorTopic& topic_;
  Probe probe_;
  Time now_{0};
  Vector3 values_ = Vector3::Zero();
};

class ScalarSensor final : public EnvironmentalSensor<ignition::msgs::Double> {
 public:
  ScalarSensor(const SensorContext& context, const Surrounding& surrounding)
      : EnvironmentalSensor(context, {scalarName(context.sensor), "", ""}, surrounding) {}

  void measure() override { message().set_data(values().x()); }
};

class VectorSensor final : public EnvironmentalSensor<ignition::msgs::Vector3d> {
 public:
  VectorSensor(const SensorContext& context, const Surrounding& surrounding)
      : EnvironmentalSensor(context, vectorNames(context.sensor), surrounding), sensor_(context.sensor) {
    const std::string transform = sensor_.sdf().get<std::string>("transform_type", "GLOBAL");
    isRelative_ = transform == "ADD_VELOCITY_LOCAL" || transform == "ADD_VELOCITY_GLOBAL";
    isLocal_ = transform == "ADD_VELOCITY_LOCAL" || transform == "LOCAL";
    if (isRelative_ || isLocal_ || transform == "GLOBAL") return;
    context.diagnostics.warning(sensor_.sdf().child("transform_type")->position,
                                "<transform_type> '" + transform + "' is unknown: GLOBAL is used, as in Gazebo",
                                "it can be GLOBAL, LOCAL, ADD_VELOCITY_GLOBAL or ADD_VELOCITY_LOCAL");
  }

  void measure() override {
    Vector3 vector = values();
    if (isRelative_) vector -= sensor_.linearVelocity();
    if (isLocal_) vector = sensor_.pose().rotation.conjugate() * vector;
    setVector(vector, message());
  }

 private:
  Sensor sensor_;
  /// Whether the sensor's velocity is subtracted.
  bool isRelative_ = false;
  /// Whether it is in the sensor's frame.
  bool isLocal_ = false;
};

class EnvironmentalSystem final : public SensorSystem, public EnvironmentUser {
 public:
  EnvironmentalSystem()
      : SensorSystem({{.sensorType = kScalar, .suffix = kSuffix, .messageType = "ignition.msgs.Double"},
                      {.sensorType = kVector, .suffix = kSuffix, .messageType = "ignition.msgs.Vector3d"}}) {}

  void declare(Declaration& declaration) override {
    declaration.is("Publishes what environmental sensors measure of the environment that EnvironmentPreload has read.",
                   Declaration::Place::kWorld);
    const std::string topic = std::string("/world/W/model/M/link/L/sensor/S") + kSuffix + "/QUANTITY";
    const std::string text = "; `<topic>` in the `<sensor>` renames it, `<update_rate>` sets its rate";
    declaration.publishes(topic, "ignition.msgs.Double",
                          "one per sensor with `type=\"custom\" gz:type=\"environmental_sensor/QUANTITY\"`" + text);
    declaration.publishes(topic, "ignition.msgs.Vector3d",
                          "instead, with `<output_format>vector3</output_format>` in the `<sensor>`");
    SensorSystem::declare(declaration);
  }

  void configure(const SystemContext& context) override {
    shareEnvironment(context.before);
    surrounding_.emplace(context.world, context.log);
    SensorSystem::configure(context);
  }

  void postUpdate(const StepInfo& info) override {
    surrounding_->update(environment(), environmentVersion());
    SensorSystem::postUpdate(info);
  }

 protected:
  std::unique_ptr<SensorDevice> make(const SensorContext& context) override {
    warnOfFormat(context);
    if (context.sensor.type() == kVector) return std::make_unique<VectorSensor>(context, *surrounding_);
    return std::make_unique<ScalarSensor>(context, *surrounding_);
  }

 private:
  static void warnOfFormat(const SensorContext& context) {
    const Element* format = context.sensor.sdf().child("output_format");
    if (format == nullptr || format->text == "scalar" || format->text == "vector3") return;
    context.diagnostics.warning(format->position,
                                "<output_format> '" + format->text + "' is unknown: scalar is used, as in Gazebo",
                                "it can be scalar or vector3");
  }

  std::optional<Surrounding> surrounding_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::EnvironmentalSystem, "gz::sim::systems::EnvironmentalSystem",
                      "ignition::gazebo::systems::EnvironmentalSystem");
