#pragma once

#include <cstdint>
#include <iterator>
#include <list>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/messages/fields.hh"
#include "pongsim/sensing/noise_set.hh"
#include "pongsim/sensing/sensor.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/system.hh"

namespace pongsim {

/// A system for all sensors of a type. `OneSensor` is the class of one sensor:
///
///     struct Thermometer {
///       using Message = ignition::msgs::Double;
///       static constexpr const char* kType = "thermometer";      // type of the <sensor>
///       static constexpr const char* kSuffix = "/temperature";   // of its default topic
///       static constexpr const char* kText = "Publishes the readings of thermometers.";
///       Thermometer(const Sensor& sensor, const World& world, NoiseSet& noises, Message& message);
///       void measure(Message& message);
///     };
///
/// The constructor may fill in constant fields of the message. If it throws an `Error`, or a std::runtime_error for a
/// missing library, the sensor is left out with a warning. `measure` is called when a message is due and has
/// subscribers, and fills in everything but the header. Its noise is saved and reset automatically.
///
/// Optional members:
/// - `void observe(const StepInfo&)`, called before `measure` in each step;
/// - `Bulk bulk()`, the large part that the message leaves out;
/// - `void reset()`, called when the world is reset;
/// - `void transfer(StateArchive&)`, which saves its state;
/// - `kHolder`, which replaces "link/L" in the documentation of its topic;
/// - `kTypes`, an array that replaces `kType` for sensors of several types;
/// - `Shared`, a class with one object for all sensors of the system. It is made from the world, the node and the
///   `<plugin>` element with the first sensor, and is the last argument of the sensors' constructors. Its
///   `void observe(const StepInfo&)` is called in each step, its `void rebuild(Diagnostics&)` first and after models
///   were added or removed;
/// - `bool isHeardElsewhere()` and `void publishElsewhere(const Message&)`, for a second topic: whether it has
///   subscribers, and publishing there. `measure` may then take a second argument: whether the message itself has
///   subscribers;
/// - `bool isReady()`, whether it takes a due reading, for sensors that skip some;
/// - `const char* suffix(const Sensor&)` and `const char* behindTopic(const Sensor&)`, which replace `kSuffix` if
/// topics
///   differ from sensor to sensor; see `SensorTopic`.
template <class OneSensor>
class SensorSystem : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is(OneSensor::kText, Declaration::Place::kWorld);
    const std::string type = OneSensor::Message::descriptor()->full_name();
    std::string holder = "link/L";
    if constexpr (requires { OneSensor::kHolder; }) holder = OneSensor::kHolder;
    declaration.publishes("/world/W/model/M/" + holder + "/sensor/S" + OneSensor::kSuffix, type,
                          "one per sensor; `<topic>` in the `<sensor>` renames it, `<update_rate>` sets its rate");
    SensorTopic::declare(declaration);
  }

  void configure(const SystemContext& context) override {
    world_ = &context.world;
    node_ = &context.node;
    plugin_ = &context.sdf;
    random_ = &context.random;
    log_ = &context.log;
    addSensors(context.diagnostics);
  }

  void worldChanged() override {
    // those that are set aside come back as they are
    std::erase_if(sensors_, [this](const Entry& entry) {
      const bool hasGone = !entry.handle.exists() && !entry.handle.isSetAside();
      if (hasGone) known_.erase(entry.handle.id().value);
      return hasGone;
    });
    for (Entry& entry : sensors_) entry.isThere = entry.handle.exists();
    Diagnostics diagnostics;
    if constexpr (kIsSharing) {
      if (shared_) shared_->rebuild(diagnostics);
    }
    addSensors(diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) log_->warning(format(diagnostic));
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused) return;
    if constexpr (kIsSharing) {
      if (shared_) shared_->observe(info);
    }
    for (Entry& entry : sensors_) {
      if (entry.isThere) entry.update(info);
    }
  }

  void reset() override {
    // in the order of the start, in which they took their random streams
    sensors_.sort([](const Entry& a, const Entry& b) { return a.handle.id() < b.handle.id(); });
    for (Entry& entry : sensors_) entry.reset(random_->split(entry.handle.scopedName()));
  }

  void transfer(StateArchive& archive) override {
    for (Entry& entry : sensors_) entry.transfer(archive);
  }

 protected:
  /// The sensor types of the system.
  static std::vector<std::string_view> types() {
    if constexpr (requires { OneSensor::kTypes; }) {
      return {std::begin(OneSensor::kTypes), std::end(OneSensor::kTypes)};
    } else {
      return {OneSensor::kType};
    }
  }

 private:
  static constexpr bool kIsSharing = requires { typename OneSensor::Shared; };
  template <class One>
  struct SharedBy {
    struct Type {};
  };
  template <class One>
  requires requires { typename One::Shared; }
  struct SharedBy<One> {
    using Type = typename One::Shared;
  };
  /// Nothing, for sensors that share nothing.
  using Shared = typename SharedBy<OneSensor>::Type;

  static const char* suffixOf(const Sensor& sensor) {
    if constexpr (requires { OneSensor::suffix(sensor); }) {
      return OneSensor::suffix(sensor);
    } else {
      return OneSensor::kSuffix;
    }
  }
  static const char* behindTopicOf(const Sensor& sensor) {
    if constexpr (requires { OneSensor::behindTopic(sensor); }) {
      return OneSensor::behindTopic(sensor);
    } else {
      return "";
    }
  }

  struct Entry {
    template <class... More>
    Entry(const Sensor& of, const World& world, Node& node, Random& random, More&... more)
        : handle(of),
          topic(of, suffixOf(of), OneSensor::Message::descriptor()->full_name(), node, behindTopicOf(of)),
          noises(random.split(of.scopedName())),
          sensor(of, world, noises, message, more...) {
      setHeaderValue("frame_id", topic.frameName(), *message.mutable_header());
    }

    void update(const StepInfo& info) {
      if constexpr (requires { sensor.observe(info); }) sensor.observe(info);
      if (!topic.isDue(info)) return;
      noises.begin(info.time, topic.sinceLast());
      if constexpr (requires { sensor.isReady(); }) {
        if (!sensor.isReady()) return;
      }
      if (!isHeard()) return;
      setStamp(info.time, *message.mutable_header());
      setHeaderValue("seq", std::to_string(topic.sequence()), *message.mutable_header());
      if constexpr (requires { sensor.measure(message, true); }) {
        sensor.measure(message, topic.hasSubscribers());
      } else {
        sensor.measure(message);
      }
      if constexpr (requires { sensor.bulk(); }) {
        topic.publish(message, sensor.bulk());
      } else {
        topic.publish(message);
      }
      if constexpr (requires { sensor.publishElsewhere(message); }) sensor.publishElsewhere(message);
    }

    bool isHeard() {
      if constexpr (requires { sensor.isHeardElsewhere(); }) {
        if (sensor.isHeardElsewhere()) return true;
      }
      return topic.hasSubscribers();
    }

    void reset(const Random& random) {
      topic.reset();
      noises.reset(random);
      if constexpr (requires { sensor.reset(); }) sensor.reset();
    }

    void transfer(StateArchive& archive) {
      topic.transfer(archive);
      noises.transfer(archive);
      if constexpr (requires { sensor.transfer(archive); }) sensor.transfer(archive);
    }

    Sensor handle;
    bool isThere = true;
    SensorTopic topic;
    NoiseSet noises;
    typename OneSensor::Message message;
    OneSensor sensor;
  };

  /// Adds new sensors.
  void addSensors(Diagnostics& diagnostics) {
    for (const std::string_view type : types()) {
      for (const Sensor& sensor : world_->sensors(type)) {
        if (known_.contains(sensor.id().value)) continue;
        try {
          add(sensor, diagnostics);
          known_.insert(sensor.id().value);
        } catch (const Error& error) {
          const Diagnostic& found = error.diagnostic();
          diagnostics.warning(found.position, found.message + ": it is left out", found.hint);
        } catch (const std::runtime_error& error) {
          diagnostics.warning(sensor.sdf().position,
                              "sensor '" + sensor.scopedName() + "' is left out: " + error.what());
        }
      }
    }
  }

  void add(const Sensor& sensor, Diagnostics& diagnostics) {
    if constexpr (kIsSharing) {
      if (!shared_) {
        shared_ = std::make_unique<Shared>(*world_, *node_, *plugin_);
        shared_->rebuild(diagnostics);
      }
      sensors_.emplace_back(sensor, *world_, *node_, *random_, *shared_);
    } else {
      sensors_.emplace_back(sensor, *world_, *node_, *random_);
    }
  }

  World* world_ = nullptr;
  Node* node_ = nullptr;
  const Element* plugin_ = nullptr;
  Random* random_ = nullptr;
  const Logger* log_ = nullptr;
  // topics stay where they are
  std::list<Entry> sensors_;
  /// Their ids.
  std::unordered_set<std::uint64_t> known_;
  std::unique_ptr<Shared> shared_;
};

}  // namespace pongsim
