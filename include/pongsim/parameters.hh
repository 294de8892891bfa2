#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pongsim/element.hh"
#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/sensing/noise_settings.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim {

// Helpers for parameters. All throw an Error with the position in the file.

/// @throws Error with that message and hint (may be empty).
[[noreturn]] PONGSIM_API void refuse(const Element& where, std::string message, std::string hint = {});

/// @return The text of a required element.
PONGSIM_API std::string requiredText(const Element& sdf, std::string_view name);

/// @return The joint named by a parameter. It must have an axis that can be commanded.
PONGSIM_API Joint requiredJoint(const Element& sdf, std::string_view name, const Model& model);

/// @return The joints named by all parameters of that name, at least one.
PONGSIM_API std::vector<Joint> requiredJoints(const Element& sdf, std::string_view name, const Model& model);

/// @return The `<noise>` settings of an element; none without one.
PONGSIM_API NoiseSettings noiseIn(const Element& holder);

/// @return The link named by a parameter.
PONGSIM_API Link requiredLink(const Element& sdf, std::string_view name, const Model& model);

/// @param rate [1/s]
/// @return The period; zero, meaning each step, for a rate that is not above zero.
PONGSIM_API Time periodOf(double rate);

/// @return The topic named by a parameter, cleaned; `fallback` if it is empty.
PONGSIM_API std::string topicOr(std::string_view named, std::string_view fallback);

/// Determines when something is due at a rate in simulated time.
class PONGSIM_API Schedule {
 public:
  /// @param period Zero: each step.
  explicit Schedule(Time period = Time::zero()) : period_(period) {}

  /// @return Whether it is due now. Due times are on a grid that begins at the start, so the mean rate is exact even if
  /// the period is not a multiple of the step.
  bool isDue(Time now) {
    if (now < due_) return false;
    if (period_ > Time::zero()) due_ = Time((now / period_ + 1) * period_.count());
    return true;
  }
  void reset() { due_ = Time::zero(); }
  void transfer(StateArchive& archive) { archive(due_); }

 private:
  Time period_;
  Time due_{0};
};

}  // namespace pongsim
