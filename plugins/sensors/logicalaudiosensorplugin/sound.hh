#pragma once

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// What a `<source>` says: a sound that is the same in all directions and falls linearly.
struct SoundSource {
  int id = 0;
  /// In the frame of the model or the world.
  Pose X_ParentSource = {};
  /// Up to there it is as loud as it is [m].
  double innerRadius = 0;
  /// From there on nothing is heard [m]; more than `innerRadius`.
  double falloffDistance = 1;
  /// 0 to 1.
  double volume = 1;
  bool plays = false;
  /// How long it plays; zero: until it is stopped.
  Time duration{0};
};

/// What a `<microphone>` says.
struct Microphone {
  int id = 0;
  /// In the frame of the model or the world.
  Pose X_ParentMicrophone = {};
  /// What is softer is not heard.
  double threshold = 0;
};

/// Reads a `<source>`. Values beyond what they can be are moved to the next that can be, with a warning.
/// @throws Error for what is missing or no value at all.
SoundSource readSource(const Element& element, Diagnostics& diagnostics);

/// Reads a `<microphone>`, likewise.
Microphone readMicrophone(const Element& element, Diagnostics& diagnostics);

/// @return How loud a source that plays is at that distance [m], 0 to 1.
double volumeAt(const SoundSource& source, double distance);

/// @return Whether that is heard. Nothing softer than 1e-5 is, whatever the threshold.
bool isHeard(double volume, const Microphone& microphone);

/// Whether a source plays, and since when.
class Playing {
 public:
  explicit Playing(const SoundSource& source) : initial_(source.plays), duration_(source.duration) { reset(); }

  /// What services ask for; it happens at the next `update`.
  void play() { wantsPlay_ = true; }
  void stop() { wantsStop_ = true; }

  /// @param now End of this step. At the first one it begins to count.
  void update(Time now);
  bool is() const { return is_; }

  void reset();
  void transfer(StateArchive& archive);

 private:
  bool initial_;
  Time duration_;
  bool is_ = false;
  bool hasBegun_ = false;
  bool wantsPlay_ = false;
  bool wantsStop_ = false;
  Time start_{0};
};

}  // namespace pongsim
