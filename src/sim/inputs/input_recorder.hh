#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "pongsim/simulation.hh"
#include "sim/inputs/recording.hh"
#include "sim/inputs/run_observer.hh"
#include "transport/input_gate.hh"

namespace pongsim::sim {

class RecordingWriter;

/// Records what a world takes in from outside, with the steps between, as long as it exists: from before the first
/// dispatch.
class InputRecorder final : public RunObserver {
 public:
  /// @param world Index of the world in the recording. All references must outlive this.
  InputRecorder(Simulation& simulation, std::uint32_t world, RecordingWriter& writer);
  ~InputRecorder() override;

  void dispatched() override;
  void served() override;
  void advanced(bool paused) override;
  void folderAdded(const std::filesystem::path& folder) override;

 private:
  void add(Passage::Kind kind);
  void addIntake();
  void addPending();
  void recordState();
  void noteUnrecorded();
  void flush();

  Simulation& simulation_;
  RecordingWriter& writer_;
  transport::InputGate gate_;
  Passage passage_;
  /// Half of a `kStep` or `kPausedStep`: `kDispatch` or `kPausedAdvance`.
  std::optional<Passage::Kind> pending_;
  /// Bytes of what was taken in since the last flush.
  std::size_t taken_ = 0;
  std::uint64_t steps_ = 0;
  /// Those that moved.
  std::uint64_t movingSteps_ = 0;
  bool hasUnrecorded_ = false;
  std::uint64_t nextState_ = 1;
};

}  // namespace pongsim::sim
