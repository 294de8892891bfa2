#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/outcome.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Handle to a battery of a model. One system sets its charge, others report their loads. Copies refer to the same
/// battery. Must not outlive its `Simulation`. A battery is removed with its model and survives a reset of the world.
class PONGSIM_API Battery {
 public:
  BatteryId id() const { return id_; }
  /// @return Whether it exists. If not, all other functions but `id` throw `Gone`.
  bool exists() const;
  std::string_view name() const;
  ModelId model() const;
  /// @return State of charge; 1: full, 0 or less: empty.
  double charge() const;
  /// Sets the state of charge. Charge and loads are not part of a saved state: systems must remember them.
  void setCharge(double charge);
  /// @return Total power drawn by all consumers [W].
  double load() const;
  /// Sets the power that a consumer draws, until changed [W]. A value that is not finite is refused with a warning.
  /// @param consumer Unique name: "thruster of joint propeller".
  void setLoad(std::string_view consumer, double load);

 private:
  friend class Batteries;
  Battery(sim::Access& access, BatteryId id) : access_(&access), id_(id) {}
  sim::Access* access_;
  BatteryId id_;
};

/// All batteries of a world. If a model has batteries and all are empty, commands to its own joints have no effect, as
/// in Fortress: the joints move freely. Must not outlive the `Simulation`.
class PONGSIM_API Batteries {
 public:
  explicit Batteries(const World& world) : access_(world.access_) {}

  /// Adds a battery to a model.
  /// @param name Unique in the model.
  /// @param charge State of charge, 1: full.
  /// @return The battery, or why it was refused.
  Outcome<Battery> add(const Model& model, std::string_view name, double charge);
  std::optional<Battery> find(const Model& model, std::string_view name) const;
  /// @return All batteries with that name, of any model.
  std::vector<Battery> named(std::string_view name) const;
  /// @return Whether the model has batteries and all are empty.
  bool areEmpty(const Model& model) const;

 private:
  sim::Access* access_;
};

}  // namespace pongsim
