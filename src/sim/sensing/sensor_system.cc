#include "pongsim/sensing/sensor_system.hh"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <tuple>

#include "pongsim/physical_properties.hh"
#include "sim/diagnostic_log.hh"

namespace pongsim {

Publisher SensorContext::advertise(std::string_view kind) const {
  const auto found = std::ranges::find(readings, kind, &SensorReadings::kind);
  if (found == readings.end()) throw std::logic_error("there are no such readings: " + std::string(kind));
  return node.advertise(topic.name() + found->behind, found->messageType);
}

SensorDevice::~SensorDevice() = default;

/// A sensor and its device, topic and noise.
struct SensorSystem::Member {
  Member(const World& world, const Sensor& sensor, std::size_t type, const SensorReadings& readings, Node& node,
         Random& random)
      : handle(sensor),
        typeNumber(type),
        topic(sensor, readings.suffix, readings.messageType, node, readings.behind),
        noises(random.split(sensor.scopedName())),
        properties(world) {
    properties.add(sensor, noises);
  }
  ~Member() { properties.remove(noises); }
  Member(const Member&) = delete;
  Member& operator=(const Member&) = delete;

  void update(const StepInfo& info) {
    device->observe(info);
    if (!topic.isDue(info)) return;
    noises.begin(info.time, topic.sinceLast());
    if (!device->isReady() || !(device->isHeardElsewhere() || topic.hasSubscribers())) return;
    device->stamp(info.time, topic.sequence());
    device->measure();
    if (const std::optional<Bulk> bulk = device->bulk()) {
      topic.publish(device->toPublish(), *bulk);
    } else {
      topic.publish(device->toPublish());
    }
    device->publishElsewhere();
  }

  Sensor handle;
  /// Index of its type in `types_`.
  std::size_t typeNumber;
  /// Whether it is in the world, and not in an unloaded level.
  bool isThere = true;
  SensorTopic topic;
  NoiseSet noises;
  /// Where its noise is known.
  PhysicalProperties properties;
  // declared last, because it refers to the members above
  std::unique_ptr<SensorDevice> device;
};

SensorSystem::SensorSystem(std::vector<SensorReadings> readings) : readings_(std::move(readings)) {
  // readings of one type are adjacent
  for (const SensorReadings& each : readings_) {
    if (types_.empty() || types_.back() != each.sensorType) types_.push_back(each.sensorType);
  }
}

SensorSystem::~SensorSystem() = default;

void SensorSystem::declare(Declaration& declaration) {
  for (const SensorReadings& each : readings_) declaration.measures(each);
  SensorTopic::declare(declaration);
}

void SensorSystem::configure(const SystemContext& context) {
  world_ = &context.world;
  node_ = &context.node;
  random_ = &context.random;
  log_ = &context.log;
  addNew(context.diagnostics);
}

void SensorSystem::worldChanged() {
  // a sensor in an unloaded level keeps its member, and with it its state
  std::erase_if(members_, [this](const std::unique_ptr<Member>& member) {
    const bool isGone = !member->handle.exists() && !member->handle.isSetAside();
    if (isGone) known_.erase(member->handle.id().value);
    return isGone;
  });
  for (const auto& member : members_) member->isThere = member->handle.exists();
  Diagnostics diagnostics;
  rebuild(diagnostics);
  addNew(diagnostics);
  sim::logDiagnostics(diagnostics, *log_);
}

void SensorSystem::postUpdate(const StepInfo& info) {
  if (info.paused) return;
  for (const auto& member : members_) {
    if (member->isThere) member->update(info);
  }
}

void SensorSystem::reset() {
  for (const auto& member : members_) {
    member->topic.reset();
    member->noises.reset(random_->split(member->handle.scopedName()));
    member->device->reset();
  }
}

void SensorSystem::transfer(StateArchive& archive) {
  for (const auto& member : members_) {
    member->topic.transfer(archive);
    member->noises.transfer(archive);
    member->device->transfer(archive);
  }
}

void SensorSystem::addNew(Diagnostics& diagnostics) {
  for (std::size_t type = 0; type < types_.size(); ++type) {
    for (const Sensor& sensor : world_->sensors(types_[type])) {
      if (!known_.contains(sensor.id().value)) add(sensor, type, diagnostics);
    }
  }
  std::ranges::sort(members_, {},
                    [](const auto& member) { return std::tuple(member->typeNumber, member->handle.id()); });
}

void SensorSystem::add(const Sensor& sensor, std::size_t type, Diagnostics& diagnostics) {
  const auto isOfType = [&](const SensorReadings& each) { return each.sensorType == types_[type]; };
  const auto first = std::ranges::find_if(readings_, isOfType);
  const std::span<const SensorReadings> readings(first, std::find_if_not(first, readings_.end(), isOfType));
  // restored if the sensor is left out: the noise of the others must be the same after a reset, which does not make it
  // again
  const Random before = *random_;
  try {
    auto member = std::make_unique<Member>(*world_, sensor, type, readings.front(), *node_, *random_);
    member->device = make({sensor, *world_, *node_, member->topic, member->noises, readings, diagnostics});
    members_.push_back(std::move(member));
    known_.insert(sensor.id().value);
    return;
  } catch (const Error& error) {
    const Diagnostic& found = error.diagnostic();
    diagnostics.warning(found.position, found.message + ": it is left out", found.hint);
  } catch (const std::runtime_error& error) {
    diagnostics.warning(sensor.sdf().position, "sensor '" + sensor.scopedName() + "' is left out: " + error.what());
  }
  *random_ = before;
}

}  // namespace pongsim
