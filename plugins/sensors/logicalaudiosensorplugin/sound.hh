#pragma once

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// A `<source>`: omnidirectional, with a volume that falls linearly with distance.
struct SoundSource {
  int id = 0;
  /// In the frame of the model or the world.
  Pose X_ParentSource = {};
  /// Full volume up to this distance [m].
  double innerRadius = 0;
  /// Inaudible from this distance on [m]; more than `innerRadius`.
  double falloffDistance = 1;
  /// 0 to 1.
  double volume = 1;
  bool plays = false;
  /// How long it plays; zero: until it is stopped.
  Time duration{0};
};

/// A `<microphone>`.
struct Microphone {
  int id = 0;
  /// In the frame of the model or the world.
  Pose X_ParentMicrophone = {};
  /// Lower volumes are not detected.
  double threshold = 0;
};

/// Reads a `<source>`. Values out of range are clamped, with a warning.
/// @throws Error for what is missing or unreadable.
SoundSource readSource(const Element& element, Diagnostics& diagnostics);

/// Reads a `<microphone>`, likewise.
Microphone readMicrophone(const Element& element, Diagnostics& diagnostics);

/// @return Volume of a playing source at that distance [m], 0 to 1.
double volumeAt(const SoundSource& source, double distance);

/// @return Whether a microphone detects it. Below 1e-5 it never does, whatever the threshold.
bool isHeard(double volume, const Microphone& microphone);

/// Whether a source plays, and since when.
class Playing {
 public:
  explicit Playing(const SoundSource& source) : initial_(source.plays), duration_(source.duration) { reset(); }

  /// Requests of services; they take effect at the next `update`.
  void play() { wantsPlay_ = true; }
  void stop() { wantsStop_ = true; }

  /// @param now End of this step. The first one starts the playing time.
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
