#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "pongsim/element.hh"
#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/system.hh"
#include "pongsim/types.hh"

namespace pongsim {

// What systems often ask of their parameters. All throw an Error that names the place in the file.

/// @throws Error with that text and, if it is not empty, that line of help.
[[noreturn]] PONGSIM_API void refuse(const Element& where, std::string message, std::string hint = {});

/// @return The model that the plugin stands in.
/// @param system For the error: "JointController".
PONGSIM_API Model requiredModel(const SystemContext& context, std::string_view system);

/// @return The text of a parameter that must be there.
PONGSIM_API std::string requiredText(const Element& sdf, std::string_view name);

/// @return The joint that a parameter names. It must have an axis that can be commanded.
PONGSIM_API Joint requiredJoint(const Element& sdf, std::string_view name, const Model& model);

/// Reads how often something is to happen [1/s].
/// @return The time between two of them; zero, which means each step, for a rate that is not above zero.
PONGSIM_API Time periodParameter(const Element& sdf, std::string_view name, double fallback);

/// @return A parameter's topic, cleaned; `fallback` where there is none.
PONGSIM_API std::string topicParameter(const Element& sdf, std::string_view name, std::string_view fallback);

/// Tells when something is due that happens at a rate of simulated time.
class PONGSIM_API Schedule {
 public:
  /// @param period Zero: each step.
  explicit Schedule(Time period = Time::zero()) : period_(period) {}

  /// @return Whether it is due now. The next one then is, on a grid that begins at the start, so that the rate is kept
  /// where it is no multiple of the step.
  bool isDue(Time now) {
    if (now < due_) return false;
    if (period_ > Time::zero()) due_ = Time((now / period_ + 1) * period_.count());
    return true;
  }
  void reset() { due_ = Time::zero(); }

 private:
  Time period_;
  Time due_{0};
};

}  // namespace pongsim
