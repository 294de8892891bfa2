#pragma once

#include <optional>

#include "pongsim/battery.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/handles.hh"
#include "pongsim/sensing/sensor.hh"

namespace pongsim {

/// What the sensors of a kind share: the visible scene, moved to its current pose at most once per step, and the
/// batteries.
template <class SeenScene>
class Surroundings {
 public:
  /// @param restsWithoutPower `<disable_on_drained_battery>`
  Surroundings(const World& world, bool restsWithoutPower)
      : scene_(world), batteries_(world), restsWithoutPower_(restsWithoutPower) {}

  /// A new step begins: poses have changed.
  void beginStep() { isCurrent_ = false; }
  void rebuild(Diagnostics& diagnostics) {
    scene_.rebuild(diagnostics);
    isCurrent_ = false;
  }

  SeenScene& scene() { return scene_; }
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
    if (!isCurrent_) scene_.update();
    isCurrent_ = true;
    return scene_;
  }

 private:
  SeenScene scene_;
  Batteries batteries_;
  bool restsWithoutPower_;
  bool isCurrent_ = false;
};

}  // namespace pongsim
