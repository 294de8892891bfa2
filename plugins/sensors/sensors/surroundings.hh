#pragma once

#include <optional>

#include "pongsim/battery.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"
#include "pongsim/handles.hh"
#include "pongsim/node.hh"
#include "pongsim/sensing/sensor.hh"
#include "pongsim/system.hh"

namespace pongsim {

/// What the sensors of a kind share: the visible scene, the node, the batteries.
template <class SeenScene>
class Surroundings {
 public:
  Surroundings(const World& world, Node& node, const Element& plugin)
      : scene_(world),
        node_(node),
        batteries_(world),
        restsWithoutPower_(plugin.get<bool>("disable_on_drained_battery", false)) {}

  void observe(const StepInfo&) { isOfNow_ = false; }
  void rebuild(Diagnostics& diagnostics) {
    scene_.rebuild(diagnostics);
    isOfNow_ = false;
  }

  SeenScene& scene() { return scene_; }
  Node& node() { return node_; }
  /// @return Whether the sensor works. With `<disable_on_drained_battery>` it does not if its model, or an outer one,
  /// has empty batteries.
  bool hasPower(const Sensor& sensor) const {
    if (!restsWithoutPower_) return true;
    for (std::optional<Model> model = sensor.link().model(); model; model = model->parent()) {
      if (batteries_.areEmpty(*model)) return false;
    }
    return true;
  }
  /// @return The scene with the poses of this step.
  SeenScene& now() {
    if (!isOfNow_) scene_.update();
    isOfNow_ = true;
    return scene_;
  }

 private:
  SeenScene scene_;
  Node& node_;
  Batteries batteries_;
  bool restsWithoutPower_;
  bool isOfNow_ = false;
};

}  // namespace pongsim
