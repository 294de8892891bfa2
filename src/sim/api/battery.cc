#include "pongsim/battery.hh"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/api/access.hh"

namespace pongsim {

namespace {

world::BatteryState* findBattery(sim::Access& access, BatteryId id) {
  const auto found = std::ranges::find(access.state.batteries, id, &world::BatteryState::id);
  return found == access.state.batteries.end() ? nullptr : &*found;
}

world::BatteryState& batteryAt(sim::Access& access, BatteryId id) {
  world::BatteryState* const found = findBattery(access, id);
  if (found == nullptr) {
    throw Gone("the battery with the id " + std::to_string(id.value) + " no longer exists");
  }
  return *found;
}

}  // namespace

bool Battery::exists() const { return findBattery(*access_, id_) != nullptr; }

std::string_view Battery::name() const { return batteryAt(*access_, id_).name; }

ModelId Battery::model() const { return batteryAt(*access_, id_).model; }

double Battery::charge() const { return batteryAt(*access_, id_).charge; }

void Battery::setCharge(double charge) { batteryAt(*access_, id_).charge = charge; }

double Battery::load() const {
  double sum = 0;
  for (const world::BatteryState::Load& load : batteryAt(*access_, id_).loads) sum += load.power;
  return sum;
}

void Battery::setLoad(std::string_view consumer, double load) {
  world::BatteryState& battery = batteryAt(*access_, id_);
  if (!std::isfinite(load)) {
    access_->refuse("battery '" + battery.name + "' was given a load that is not finite");
    return;
  }
  const auto found = std::ranges::find(battery.loads, consumer, &world::BatteryState::Load::consumer);
  if (found != battery.loads.end()) {
    found->power = load;
  } else {
    battery.loads.push_back({std::string(consumer), load});
  }
}

Outcome<Battery> Batteries::add(const Model& model, std::string_view name, double charge) {
  if (find(model, name)) {
    return {std::nullopt, "model '" + model.scopedName() + "' has a battery '" + std::string(name) + "' already"};
  }
  const BatteryId id{access_->entities.nextId()};
  access_->state.batteries.push_back({id, model.id(), std::string(name), charge, {}});
  return {Battery(*access_, id), {}};
}

std::optional<Battery> Batteries::find(const Model& model, std::string_view name) const {
  for (const world::BatteryState& battery : access_->state.batteries) {
    if (battery.model == model.id() && battery.name == name) return Battery(*access_, battery.id);
  }
  return std::nullopt;
}

std::vector<Battery> Batteries::named(std::string_view name) const {
  std::vector<Battery> found;
  for (const world::BatteryState& battery : access_->state.batteries) {
    if (battery.name == name) found.push_back(Battery(*access_, battery.id));
  }
  return found;
}

bool Batteries::areEmpty(const Model& model) const { return world::isOutOfPower(access_->state, model.id()); }

}  // namespace pongsim
