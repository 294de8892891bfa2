#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/outcome.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// A way to one battery of a model: a system says how full it is, others say what they take from it. A copy is the same
/// battery; it must not outlive its `Simulation`. A battery goes with its model and stays where the world is reset.
class PONGSIM_API Battery {
 public:
  BatteryId id() const { return id_; }
  /// @return Whether it is still there. If not, all other functions but `id` throw `Gone`.
  bool exists() const;
  std::string_view name() const;
  ModelId model() const;
  /// @return State of charge, 1: full; 0 or less: empty.
  double charge() const;
  /// Says how full it is. Neither this nor the loads are part of a saved state: systems remember what they say.
  void setCharge(double charge);
  /// @return What is taken from it, of all consumers together [W].
  double load() const;
  /// Says what a consumer takes from it, until it says something else [W]. A load that is not finite is refused with a
  /// warning.
  /// @param consumer A name of its own: "thruster of joint propeller".
  void setLoad(std::string_view consumer, double load);

 private:
  friend class Batteries;
  Battery(sim::Access& access, BatteryId id) : access_(&access), id_(id) {}
  sim::Access* access_;
  BatteryId id_;
};

/// All batteries of a world. A model that has some which are all empty gets no force and no velocity on its own joints,
/// whatever they are told: as in Fortress they turn on freely. It must not outlive the `Simulation`.
class PONGSIM_API Batteries {
 public:
  explicit Batteries(const World& world) : access_(world.access_) {}

  /// Gives a model a battery.
  /// @param name Of no other battery of the model.
  /// @param charge State of charge, 1: full.
  /// @return The battery, or why not.
  Outcome<Battery> add(const Model& model, std::string_view name, double charge);
  std::optional<Battery> find(const Model& model, std::string_view name) const;
  /// @return All batteries of that name, whatever their models.
  std::vector<Battery> named(std::string_view name) const;
  /// @return Whether the model has batteries and all of them are empty.
  bool areEmpty(const Model& model) const;

 private:
  sim::Access* access_;
};

}  // namespace pongsim
