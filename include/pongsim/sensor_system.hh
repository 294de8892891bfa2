#pragma once

#include <algorithm>
#include <iterator>
#include <list>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/fields.hh"
#include "pongsim/noise_set.hh"
#include "pongsim/sensor.hh"
#include "pongsim/state_archive.hh"
#include "pongsim/system.hh"

namespace pongsim {

/// A system of all sensors of a type. `OneSensor` is one of them:
///
///     struct Thermometer {
///       using Message = ignition::msgs::Double;
///       static constexpr const char* kType = "thermometer";      // of the <sensor>
///       static constexpr const char* kSuffix = "/temperature";   // of its topic, where it names none
///       static constexpr const char* kText = "Publishes how warm it is.";
///       Thermometer(const Sensor& sensor, const World& world, NoiseSet& noises, Message& message);
///       void measure(Message& message);
///     };
///
/// The constructor may fill in what never changes, and throws an `Error` for a sensor that can't be had, which is left
/// out with a warning; so it is where a library is missing (std::runtime_error). `measure` is called when a message is
/// due and somebody listens, and fills in all but the header. Where there are, `void observe(const StepInfo&)` is
/// called before it in each step, `Bulk bulk()` says where the pixels are that the message leaves out, `void reset()`
/// where the world is set back, and `kHolder` names what holds the sensor in its topic, in place of "link/L". What it
/// remembers it tells by `void transfer(StateArchive&)`; its noise is taken care of.
///
/// Sensors of several types have `kTypes`, an array, in place of `kType`. `Shared` is what those of a system share:
/// made of the world, the node and the `<plugin>` element with the first of them, given to their constructors as the
/// last argument, its `void observe(const StepInfo&)` called in each step, its `void rebuild(Diagnostics&)` at first
/// and where models have come or gone. A sensor with a second topic says by `bool isHeardElsewhere()` whether somebody
/// listens there, and publishes there by `void publishElsewhere(const Message&)` what it has measured; its `measure`
/// may ask for a second argument, whether somebody listens to the message itself. One that does not take every reading
/// that is due says by `bool isReady()` whether it takes this one. Where topics differ from sensor to sensor, the
/// functions `const char* suffix(const Sensor&)` and `const char* behindTopic(const Sensor&)` of the class stand for
/// `kSuffix`; see `SensorTopic`.
template <class OneSensor>
class SensorSystem : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is(OneSensor::kText, Declaration::Place::kWorld);
    const std::string type = OneSensor::Message::descriptor()->full_name();
    std::string holder = "link/L";
    if constexpr (requires { OneSensor::kHolder; }) holder = OneSensor::kHolder;
    declaration.publishes("/world/W/model/M/" + holder + "/sensor/S" + OneSensor::kSuffix, type,
                          "of each sensor; `<topic>` in the `<sensor>` names another, `<update_rate>` says how often");
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
    std::erase_if(sensors_, [](const Entry& entry) { return !entry.handle.exists() && !entry.handle.isSetAside(); });
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
  /// The types of sensors that the system takes care of.
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

  /// Adds those that are not there yet.
  void addSensors(Diagnostics& diagnostics) {
    for (const std::string_view type : types()) {
      for (const Sensor& sensor : world_->sensors(type)) {
        const bool isKnown =
            std::ranges::any_of(sensors_, [&](const Entry& entry) { return entry.handle.id() == sensor.id(); });
        if (isKnown) continue;
        try {
          add(sensor, diagnostics);
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
  std::unique_ptr<Shared> shared_;
};

}  // namespace pongsim
