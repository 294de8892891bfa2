#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "pongsim/bulk.hh"
#include "pongsim/declaration.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/export.hh"
#include "pongsim/message.hh"
#include "pongsim/messages/fields.hh"
#include "pongsim/sensing/noise_set.hh"
#include "pongsim/sensing/sensor.hh"
#include "pongsim/sensing/sensor_topic.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/system.hh"

namespace pongsim {

/// What a sensor is made from. The references are valid as long as the sensor, `readings` and `diagnostics` during its
/// constructor only.
struct PONGSIM_API SensorContext {
  /// Its handle.
  Sensor sensor;
  const World& world;
  Node& node;
  /// Its topic and schedule.
  SensorTopic& topic;
  /// The place for its noise, which is begun, reset and saved with it.
  NoiseSet& noises;
  /// What its system publishes of sensors of its type; the first on `topic`.
  std::span<const SensorReadings> readings;
  /// For warnings about its element.
  Diagnostics& diagnostics;

  /// Advertises the topic of readings other than the first.
  /// @param kind One of `readings`.
  Publisher advertise(std::string_view kind) const;
};

/// One sensor of a `SensorSystem`. Sensors derive from `SensorOf`.
class PONGSIM_API SensorDevice {
 public:
  SensorDevice() = default;
  virtual ~SensorDevice();
  SensorDevice(const SensorDevice&) = delete;
  SensorDevice& operator=(const SensorDevice&) = delete;

  /// Called first in each step that is not paused, for values that depend on all steps, such as accelerations.
  virtual void observe(const StepInfo&) {}
  /// Called when a reading is due.
  /// @return Whether to take it; false for a sensor that waits for a trigger or has no power.
  virtual bool isReady() { return true; }
  /// Fills in all of the message but its header. Called when a reading is due and `topic` or `isHeardElsewhere` says
  /// that it has subscribers.
  virtual void measure() = 0;
  /// @return The part of the message that is kept outside of it, such as pixels; nothing if it is complete.
  virtual std::optional<Bulk> bulk() { return std::nullopt; }
  /// @return Whether `publishElsewhere` has subscribers.
  virtual bool isHeardElsewhere() const { return false; }
  /// Publishes readings on further topics. Called after each `measure`, when its message has been published.
  virtual void publishElsewhere() {}
  /// The world was reset. Topic and noise have been reset.
  virtual void reset() {}
  /// Saves or restores its state, like `System::transfer`; its schedule and noise are saved by the system.
  virtual void transfer(StateArchive&) {}

 private:
  friend class SensorSystem;
  virtual const pongsim::Message& toPublish() const = 0;
  virtual void stamp(Time time, std::uint64_t sequence) = 0;
};

/// A sensor that publishes messages of a type, which has a field `header` of the type ignition.msgs.Header:
///
///     class Thermometer final : public SensorOf<ignition::msgs::Double> {
///      public:
///       static constexpr SensorKind kKind{.text = "Publishes the readings of thermometers.",
///                                         .type = "thermometer",
///                                         .suffix = "/temperature"};
///       explicit Thermometer(const SensorContext& context) : SensorOf(context), sensor_(context.sensor) {}
///       void measure() override { message().set_data(temperatureAt(sensor_.pose().position)); }
///
///      private:
///       Sensor sensor_;
///     };
///     PONGSIM_EXPORT_SYSTEM(SensorSystemFor<Thermometer>, "Thermometer");
template <class MessageType>
class SensorOf : public SensorDevice {
 public:
  using Message = MessageType;

 protected:
  explicit SensorOf(const SensorContext& context) {
    setHeaderValue("frame_id", context.topic.frameName(), *message_.mutable_header());
  }
  /// The message, which keeps its fields from one reading to the next. A constructor may fill in those that are
  /// constant.
  Message& message() { return message_; }
  const Message& message() const { return message_; }

 private:
  const pongsim::Message& toPublish() const final { return message_; }
  void stamp(Time time, std::uint64_t sequence) final {
    setStamp(time, *message_.mutable_header());
    setHeaderValue("seq", std::to_string(sequence), *message_.mutable_header());
  }

  Message message_;
};

/// A system for all sensors of some types: it makes them, also those of models that are inserted later, calls them in
/// each step in the order of their types, then of the file, and saves and resets them.
class PONGSIM_API SensorSystem : public System {
 public:
  ~SensorSystem() override;

  /// Declares the readings and what `SensorTopic` offers. A derived class adds the rest.
  void declare(Declaration& declaration) override;
  void configure(const SystemContext& context) override;
  void worldChanged() override;
  void postUpdate(const StepInfo& info) override;
  void reset() override;
  void transfer(StateArchive& archive) override;

 protected:
  /// @param readings What it publishes of sensors of each type; the first of a type is its message.
  explicit SensorSystem(std::vector<SensorReadings> readings);

  /// Makes a sensor.
  /// @throws Error, or std::runtime_error for a missing library; the sensor is then left out with a warning.
  virtual std::unique_ptr<SensorDevice> make(const SensorContext& context) = 0;
  /// Models were added or removed; called before sensors of new models are made.
  virtual void rebuild(Diagnostics&) {}

 private:
  struct Member;
  void addNew(Diagnostics& diagnostics);
  void add(const Sensor& sensor, std::size_t type, Diagnostics& diagnostics);

  std::vector<SensorReadings> readings_;
  /// Those of `readings_`, each once, in their order.
  std::vector<std::string> types_;
  World* world_ = nullptr;
  Node* node_ = nullptr;
  Random* random_ = nullptr;
  const Logger* log_ = nullptr;
  /// By type, then by id: the order in which they were given their random streams, also after a reset.
  std::vector<std::unique_ptr<Member>> members_;
  /// Ids of their sensors.
  std::unordered_set<std::uint64_t> known_;
};

/// What a `SensorSystemFor` tells of its sensors.
struct SensorKind {
  /// What the system does, in a sentence.
  const char* text;
  /// Type of the `<sensor>`.
  const char* type;
  /// Of its default topic, with a slash (`Sensor::topic`).
  const char* suffix;
  /// The sensor's parent in the documentation of the topic.
  const char* holder = "link/L";
};

/// The system of a sensor class, `OneSensor`, that is derived from `SensorOf`, has a `SensorKind` called `kKind`, and
/// is constructed from a `SensorContext`.
template <class OneSensor>
class SensorSystemFor : public SensorSystem {
 public:
  SensorSystemFor()
      : SensorSystem({{.sensorType = OneSensor::kKind.type,
                       .kind = SensorReadings::kMessage,
                       .suffix = OneSensor::kKind.suffix,
                       .behind = {},
                       .messageType = messageType()}}) {}

  void declare(Declaration& declaration) override {
    constexpr const SensorKind& kind = OneSensor::kKind;
    declaration.is(kind.text, Declaration::Place::kWorld);
    declaration.publishes(std::string("/world/W/model/M/") + kind.holder + "/sensor/S" + kind.suffix, messageType(),
                          "one per sensor; `<topic>` in the `<sensor>` renames it, `<update_rate>` sets its rate");
    SensorSystem::declare(declaration);
  }

 protected:
  std::unique_ptr<SensorDevice> make(const SensorContext& context) override {
    return std::make_unique<OneSensor>(context);
  }

 private:
  static std::string messageType() { return OneSensor::Message::descriptor()->full_name(); }
};

}  // namespace pongsim
