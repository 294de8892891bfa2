#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// What a light shows: red, green, blue and alpha, 0 to 1, and its intensity.
struct Glow {
  std::array<double, 4> color{1, 1, 1, 1};
  double intensity = 1;
  bool operator==(const Glow&) const = default;

  void transfer(StateArchive& archive) {
    for (double& part : color) archive(part);
    archive(intensity);
  }
};

/// Reads `<color>` and `<intensity>`.
/// @param fallback For what is not given.
/// @throws Error for an invalid value.
Glow glowIn(const Element& element, const Glow& fallback);

/// A step of a mode.
struct LedStep {
  Glow glow;
  /// How long it lasts, unless it lasts for ever.
  Time duration = std::chrono::seconds(1);
  bool lasts = false;
};

/// A sequence of steps that repeats.
struct LedMode {
  /// In small letters.
  std::string name;
  /// Empty: all.
  std::vector<std::string> leds;
  /// At least one.
  std::vector<LedStep> steps;
};

/// Reads the `<mode>`s. One without a name or a step is left out with a warning.
/// @throws Error for an invalid value.
std::vector<LedMode> ledModesIn(const Element& plugin, Diagnostics& diagnostics);

/// @return `text` in small letters.
std::string inSmallLetters(std::string text);

/// Which mode LEDs are in, and which of its steps.
class Blinking {
 public:
  /// Begins a mode, by its index.
  void begin(std::uint64_t mode) {
    mode_ = mode;
    step_ = 0;
    hasStarted_ = false;
    isOff_ = false;
  }
  void switchOff() { isOff_ = true; }
  bool isOff() const { return isOff_; }
  std::uint64_t mode() const { return mode_; }

  /// @return The step at `now`. Call it in each step of the simulation.
  const LedStep& step(const std::vector<LedMode>& modes, Time now);

  void transfer(StateArchive& archive, const std::vector<LedMode>& modes);

 private:
  std::uint64_t mode_ = 0;
  std::uint64_t step_ = 0;
  /// Of the step, once it has begun.
  Time start_{0};
  bool hasStarted_ = false;
  bool isOff_ = false;
};

}  // namespace pongsim
