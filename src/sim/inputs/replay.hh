#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/simulation.hh"
#include "sim/inputs/recording.hh"
#include "sim/running/run_control.hh"
#include "sim/running/run_history.hh"
#include "sim/running/run_services.hh"
#include "sim/running/server_services.hh"
#include "transport/input_gate.hh"

namespace pongsim::sim {

/// Runs a world again with recorded inputs and nothing else from outside.
class Replay {
 public:
  /// @param simulation Must not have made a step, and needs no systems that stand outside. All references must outlive
  /// this.
  /// @param paused Whether the recorded run began paused.
  Replay(const Tape& tape, Simulation& simulation, bool paused);

  /// Goes on to the end of the next step, moving or not.
  /// @return False at the end of the recording.
  bool advance();

  /// @return Steps made, moving or not; of these, those that moved.
  std::uint64_t advances() const { return advances_; }
  std::uint64_t steps() const { return steps_; }
  /// @return Whether the state had the recorded bits after the last step.
  bool isAsRecorded() const { return isAsRecorded_; }
  /// @return What the recording has inputs for and the world lacks, as `InputGate::missing` says, in the last step.
  const std::vector<std::string>& missing() const { return missing_; }
  /// @return The recorded state after the last step, if that was recorded.
  const StateValues* recordedState() const;
  bool isPaused() const { return control_.paused(); }

 private:
  bool next(Passage::Kind& kind);
  void dispatch();
  void serve();
  void takeMissing();
  void step(bool paused);

  const Tape& tape_;
  Simulation& simulation_;
  RunControl control_;
  RunHistory history_;
  RunServices services_;
  ServerServices serverServices_;
  transport::InputGate gate_;

  // Where it is: passage, run in it, how often that was carried out; the next of the passage's lists.
  std::size_t passage_ = 0;
  std::size_t run_ = 0;
  std::uint64_t done_ = 0;
  std::size_t intake_ = 0;
  std::size_t folder_ = 0;
  std::size_t change_ = 0;
  // The next hash, in a passage of its own: hashes may be written before the step that they belong to.
  std::size_t hashPassage_ = 0;
  std::size_t hash_ = 0;

  std::uint64_t advances_ = 0;
  std::uint64_t steps_ = 0;
  bool isAsRecorded_ = true;
  std::vector<std::string> missing_;
};

}  // namespace pongsim::sim
