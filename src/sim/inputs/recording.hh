#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/element.hh"
#include "pongsim/outcome.hh"
#include "pongsim/state/state_archive.hh"
#include "sim/inputs/outside_changes.hh"
#include "sim/inputs/state_values.hh"
#include "transport/input_gate.hh"

namespace pongsim::sim {

/// What a run begins with.
struct RunStart {
  /// A file of a world, such as a mesh, with a hash of its content.
  struct File {
    std::string path;
    std::uint64_t hash = 0;
    void transfer(StateArchive& archive);
    bool operator==(const File&) const = default;
  };

  /// Of pongsim.
  std::string version;
  /// The world file; empty for the empty world.
  std::string file;
  /// Its content, with each `<include>` replaced.
  std::string sdf;
  std::vector<File> files;
  /// The names of the worlds that run.
  std::vector<std::string> worlds;
  /// The options of the run: the only world to run, or empty; added systems.
  std::string onlyWorld;
  std::vector<Element> systems;
  std::uint64_t seed = 0;
  bool levels = false;
  bool allowPluginPaths = false;
  bool paused = false;

  void transfer(StateArchive& archive);
};

/// A part of what happened to one world.
struct Passage {
  enum class Kind : std::uint8_t {
    /// A dispatch and then a step.
    kStep,
    /// The systems called without a step, then a dispatch.
    kPausedStep,
    kDispatch,
    kAdvance,
    kPausedAdvance,
    /// The next dispatch takes in the next one of `intakes`.
    kIntake,
    /// The next one of `folders` is added.
    kFolder,
    /// The next step makes the next one of `changes`.
    kChange,
    /// A dispatch of requests, and no messages.
    kServe
  };
  /// As often as `count` says.
  struct Run {
    Kind kind = Kind::kStep;
    std::uint64_t count = 0;
    void transfer(StateArchive& archive);
  };

  std::uint32_t world = 0;
  std::vector<Run> runs;
  std::vector<transport::Intake> intakes;
  std::vector<std::string> folders;
  std::vector<OutsideChange> changes;
  /// `quickHash` after each step, moving or not.
  std::vector<std::uint64_t> hashes;

  void transfer(StateArchive& archive);
};

/// The state of one world after a number of steps, those without motion included.
struct RecordedState {
  std::uint32_t world = 0;
  std::uint64_t steps = 0;
  StateValues values;
  void transfer(StateArchive& archive);
};

/// A change by a system that stands outside, which is no message or request, and not recorded.
struct UnrecordedChange {
  std::uint32_t world = 0;
  /// Steps before it, moving ones.
  std::uint64_t steps = 0;
  void transfer(StateArchive& archive);
};

/// How a world has ended.
struct WorldEnd {
  std::uint32_t world = 0;
  std::uint64_t stateHash = 0;
  void transfer(StateArchive& archive);
};

/// What was recorded of one world.
struct Tape {
  std::vector<Passage> passages;
  std::vector<RecordedState> states;
  /// Steps before the first change that is not recorded; nothing without one.
  std::optional<std::uint64_t> unrecordedAfter;
  /// `Simulation::stateHash`; nothing if the recording was cut off.
  std::optional<std::uint64_t> endHash;
};

/// A recording of the inputs of a run.
struct Recording {
  RunStart start;
  /// In the order of `RunStart::worlds`.
  std::vector<Tape> tapes;
  /// Why it ends before the run did: "it is cut off after 1200 bytes"; empty if it does not.
  std::string cut;
};

/// What a frame of the file contains.
enum class FrameKind : std::uint8_t { kStart, kPassage, kState, kUnrecordedChange, kWorldEnd, kEnd };

/// Begins a file of recorded inputs.
inline constexpr std::string_view kRecordingMark = "pongsim inputs 1\n";

/// @return The bytes of a frame: size, kind, content and a hash of these.
std::vector<std::byte> frameOf(FrameKind kind, std::vector<std::byte> content);

/// The same of something with a `transfer`.
template <class Content>
std::vector<std::byte> frameWith(FrameKind kind, const Content& content) {
  StateArchive archive;
  // writing changes nothing
  const_cast<Content&>(content).transfer(archive);
  return frameOf(kind, archive.take());
}

/// @return Whether the file begins like a recording of inputs.
bool isRecording(const std::filesystem::path& file);

/// Reads a recording, up to where it is cut off or damaged.
/// @return Or why it can't be used: "is not a recording of inputs".
Outcome<Recording> readRecording(const std::filesystem::path& file);

}  // namespace pongsim::sim
