#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pongsim/element.hh"
#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/noise_settings.hh"
#include "pongsim/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim {

// What systems often make of their parameters. All throw an Error that names the place in the file.

/// @throws Error with that text and, if it is not empty, that line of help.
[[noreturn]] PONGSIM_API void refuse(const Element& where, std::string message, std::string hint = {});

/// @return The text of an element that must be there.
PONGSIM_API std::string requiredText(const Element& sdf, std::string_view name);

/// @return The joint that a parameter names. It must have an axis that can be commanded.
PONGSIM_API Joint requiredJoint(const Element& sdf, std::string_view name, const Model& model);

/// @return The joints that all parameters of that name name, at least one.
PONGSIM_API std::vector<Joint> requiredJoints(const Element& sdf, std::string_view name, const Model& model);

/// @return How the `<noise>` of an element falsifies a value; none where it has none.
PONGSIM_API NoiseSettings noiseIn(const Element& holder);

/// @return The link that a parameter names.
PONGSIM_API Link requiredLink(const Element& sdf, std::string_view name, const Model& model);

/// @param rate How often something is to happen [1/s].
/// @return The time between two of them; zero, which means each step, for a rate that is not above zero.
PONGSIM_API Time periodOf(double rate);

/// @return The topic that a parameter names, cleaned; `fallback` where it is empty.
PONGSIM_API std::string topicOr(std::string_view named, std::string_view fallback);

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
  void transfer(StateArchive& archive) { archive(due_); }

 private:
  Time period_;
  Time due_{0};
};

}  // namespace pongsim
