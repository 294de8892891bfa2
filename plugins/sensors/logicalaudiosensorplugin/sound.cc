#include "sound.hh"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/parameters.hh"

namespace pongsim {

namespace {

// Lower volumes are inaudible.
constexpr double kSilence = 1e-5;

const Element& required(const Element& element, const char* name) {
  const Element* found = element.child(name);
  if (found == nullptr || found->text.empty()) refuse(element, "no <" + std::string(name) + "> is given");
  return *found;
}

double finite(const Element& element) {
  const double value = element.as<double>();
  if (!std::isfinite(value)) refuse(element, "<" + element.name + "> must be a finite number");
  return value;
}

int readId(const Element& element) {
  const Element& id = required(element, "id");
  const int value = id.as<int>();
  if (value < 0) refuse(id, "<id> must be zero or more");
  return value;
}

Pose readPose(const Element& element, Diagnostics& diagnostics) {
  const Element* pose = element.child("pose");
  if (pose == nullptr || pose->text.empty()) {
    diagnostics.warning(element.position, "this <" + element.name + "> has no <pose>: it is where its parent is");
    return {};
  }
  std::istringstream words(pose->text);
  std::vector<std::string> all;
  for (std::string word; words >> word;) all.push_back(word);
  if (all.size() != 6) refuse(*pose, "<pose> is '" + pose->text + "', which is not six numbers");
  Element half = *pose;
  half.text = all[0] + " " + all[1] + " " + all[2];
  const auto position = half.as<Vector3>();
  half.text = all[3] + " " + all[4] + " " + all[5];
  const auto angles = half.as<Vector3>();
  if (!position.allFinite() || !angles.allFinite()) refuse(*pose, "<pose> must be finite");
  return {position, fromRollPitchYaw(angles.x(), angles.y(), angles.z())};
}

/// Refuses any word except the supported one, in upper or lower case.
void requireWord(const Element& element, const char* name, const std::string& known) {
  const Element& found = required(element, name);
  std::string text = found.text;
  std::ranges::transform(text, text.begin(), [](unsigned char letter) { return std::tolower(letter); });
  if (text != known) refuse(found, "<" + found.name + "> is '" + found.text + "'", "it can be '" + known + "'");
}

/// @return `wanted`, with a warning if `value` is another.
double moved(const Element& element, double value, double wanted, Diagnostics& diagnostics) {
  if (value == wanted) return wanted;
  std::ostringstream text;
  text << "<" << element.name << "> is " << value << ": " << wanted << " is used";
  diagnostics.warning(element.position, text.str());
  return wanted;
}

}  // namespace

SoundSource readSource(const Element& element, Diagnostics& diagnostics) {
  SoundSource source;
  source.id = readId(element);
  source.X_ParentSource = readPose(element, diagnostics);
  requireWord(element, "attenuation_function", "linear");
  requireWord(element, "attenuation_shape", "sphere");
  const Element& inner = required(element, "inner_radius");
  const Element& falloff = required(element, "falloff_distance");
  const Element& volume = required(element, "volume_level");
  const double radius = finite(inner), distance = finite(falloff), level = finite(volume);
  source.innerRadius = moved(inner, radius, std::max(radius, 0.0), diagnostics);
  const double least = source.innerRadius + 1;
  source.falloffDistance = moved(falloff, distance, distance > source.innerRadius ? distance : least, diagnostics);
  source.volume = moved(volume, level, std::clamp(level, 0.0, 1.0), diagnostics);
  source.plays = required(element, "playing").as<bool>();
  const Element& duration = required(element, "play_duration");
  const double seconds = duration.as<double>();
  if (!(seconds >= 0) || seconds > 1e9) refuse(duration, "<play_duration> must be 0 to 1e9 s");
  source.duration = fromSeconds(seconds);
  return source;
}

Microphone readMicrophone(const Element& element, Diagnostics& diagnostics) {
  Microphone microphone;
  microphone.id = readId(element);
  microphone.X_ParentMicrophone = readPose(element, diagnostics);
  if (const Element* threshold = element.child("volume_threshold")) {
    microphone.threshold = finite(*threshold);
  } else {
    diagnostics.warning(element.position, "this <microphone> has no <volume_threshold>: it detects everything");
  }
  return microphone;
}

double volumeAt(const SoundSource& source, double distance) {
  if (distance <= source.innerRadius) return source.volume;
  if (distance >= source.falloffDistance) return 0;
  return source.volume * (1 - (distance - source.innerRadius) / (source.falloffDistance - source.innerRadius));
}

bool isHeard(double volume, const Microphone& microphone) {
  return volume >= kSilence && volume >= microphone.threshold;
}

void Playing::update(Time now) {
  if (!std::exchange(hasBegun_, true)) start_ = now;
  if (std::exchange(wantsPlay_, false) && !is_) {
    start_ = now;
    is_ = true;
  }
  if (std::exchange(wantsStop_, false)) is_ = false;
  if (duration_ > Time::zero() && now - start_ > duration_) is_ = false;
}

void Playing::reset() {
  is_ = initial_;
  hasBegun_ = wantsPlay_ = wantsStop_ = false;
  start_ = Time::zero();
}

void Playing::transfer(StateArchive& archive) {
  archive(is_);
  archive(hasBegun_);
  archive(wantsPlay_);
  archive(wantsStop_);
  archive(start_);
}

}  // namespace pongsim
