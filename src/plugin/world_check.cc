#include "plugin/world_check.hh"

#include <memory>
#include <vector>

#include "description/model_sensors.hh"
#include "plugin/core_systems.hh"
#include "plugin/loader.hh"
#include "plugin/sensor_plugins.hh"

namespace pongsim::plugin {

namespace {

class Check {
 public:
  explicit Check(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  void addPlugins(const std::vector<description::Plugin>& plugins) {
    for (const description::Plugin& plugin : plugins) {
      if (description::isLevelPlan(plugin.className)) continue;
      if (const CoreSystem* core = coreSystem(plugin.filename)) {
        loader_.reportLimit(*core, plugin.sdf.position, diagnostics_);
        continue;
      }
      const std::unique_ptr<System> system =
          loader_.load(plugin, Loader::Paths::kNeedLeave, Loader::Need::kOptional, diagnostics_);
      if (system == nullptr) continue;
      Declaration declaration;
      system->declare(declaration);
      sensors_.add(declaration);
    }
  }

  void addModel(const description::Model& model) {
    addPluginsOf(model);
    description::forEachSensor(model, [this](const description::Sensor& sensor) { sensors_.add(sensor); });
  }

  void reportPlugins() { loader_.reportMissing(diagnostics_); }
  void reportSensors() { sensors_.report(diagnostics_); }

 private:
  void addPluginsOf(const description::Model& model) {
    addPlugins(model.plugins);
    for (const description::Link& link : model.links) {
      for (const description::Visual& visual : link.visuals) addPlugins(visual.plugins);
    }
    description::forEachOwnSensor(
        model, [this](const description::Sensor& sensor, const std::string&) { addPlugins(sensor.plugins); });
    for (const description::Model& nested : model.models) addPluginsOf(nested);
  }

  Diagnostics& diagnostics_;
  Loader loader_;
  SensorCheck sensors_;
};

}  // namespace

void checkPlugins(const description::World& world, Diagnostics& diagnostics) {
  Check check(diagnostics);
  check.addPlugins(world.plugins);
  for (const description::Model& model : world.models) check.addModel(model);
  for (const description::Actor& actor : world.actors) check.addPlugins(actor.plugins);
  check.reportPlugins();
  check.reportSensors();
}

void checkPlugins(const description::Model& model, Diagnostics& diagnostics) {
  Check check(diagnostics);
  check.addModel(model);
  check.reportPlugins();
}

}  // namespace pongsim::plugin
