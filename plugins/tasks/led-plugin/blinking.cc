#include "blinking.hh"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include "pongsim/parameters.hh"

namespace pongsim {

namespace {

/// The longest step [s].
constexpr double kLongest = 1e9;

double atLeastZero(const Element& element) {
  const double value = element.as<double>();
  if (!(value >= 0) || !std::isfinite(value)) refuse(element, "<" + element.name + "> must be zero or more");
  return value;
}

LedStep stepOf(const Element& element) {
  LedStep step;
  step.glow = glowIn(element, {});
  const std::string lasts = element.attributeOr("always_on", "false");
  step.lasts = lasts == "true" || lasts == "1";
  if (const Element* time = element.child("on_time")) {
    step.duration = fromSeconds(std::min(atLeastZero(*time), kLongest));
  }
  return step;
}

}  // namespace

Glow glowIn(const Element& element, const Glow& fallback) {
  Glow glow = fallback;
  if (const Element* color = element.child("color")) {
    std::istringstream stream(color->text);
    std::size_t count = 0;
    glow.color[3] = 1;
    for (std::string word; stream >> word; ++count) {
      Element number;
      number.name = color->name;
      number.text = word;
      number.position = color->position;
      const double value = number.as<double>();
      if (count > 3 || !(value >= 0 && value <= 1)) refuse(*color, "<color> is not red, green, blue and alpha, 0 to 1");
      glow.color[count] = value;
    }
    if (count < 3) refuse(*color, "<color> is not red, green, blue and alpha, 0 to 1");
  }
  if (const Element* intensity = element.child("intensity")) glow.intensity = atLeastZero(*intensity);
  return glow;
}

std::vector<LedMode> ledModesIn(const Element& plugin, Diagnostics& diagnostics) {
  std::vector<LedMode> modes;
  for (const Element* element : plugin.childrenNamed("mode")) {
    LedMode mode{.name = inSmallLetters(element->attributeOr("name", "")), .leds = {}, .steps = {}};
    for (const Element* step : element->childrenNamed("step")) mode.steps.push_back(stepOf(*step));
    if (const Element* active = element->child("active_leds")) {
      for (const Element* led : active->childrenNamed("led")) mode.leds.push_back(led->text);
    }
    if (mode.name.empty() || mode.steps.empty()) {
      diagnostics.warning(element->position, std::string("a <mode> without a ") +
                                                 (mode.name.empty() ? "name" : "<step>") + " is left out");
      continue;
    }
    modes.push_back(std::move(mode));
  }
  return modes;
}

std::string inSmallLetters(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

const LedStep& Blinking::step(const std::vector<LedMode>& modes, Time now) {
  const std::vector<LedStep>& steps = modes[mode_].steps;
  if (!hasStarted_) start_ = now;
  hasStarted_ = true;
  if (!steps[step_].lasts && now - start_ > steps[step_].duration) {
    step_ = (step_ + 1) % steps.size();
    start_ = now;
  }
  return steps[step_];
}

void Blinking::transfer(StateArchive& archive, const std::vector<LedMode>& modes) {
  archive(mode_);
  archive(step_);
  archive(start_);
  archive(hasStarted_);
  archive(isOff_);
  if (archive.isGiving()) archive.check(mode_ < modes.size() && step_ < modes[mode_].steps.size());
}

}  // namespace pongsim
