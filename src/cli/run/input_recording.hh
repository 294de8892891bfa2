#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "pongsim/simulation.hh"
#include "sim/inputs/recording_writer.hh"
#include "sim/running/runner.hh"

namespace pongsim::cli {

/// Records the inputs of a run.
class InputRecording {
 public:
  /// @param worlds Those that run. Must outlive this.
  /// @throws std::runtime_error if the file can't be written.
  InputRecording(const std::filesystem::path& file, const sim::RunStart& start,
                 const std::vector<std::unique_ptr<Simulation>>& worlds)
      : worlds_(worlds), writer_(file, start) {}

  /// Makes the run record its inputs, and end where that fails.
  void addTo(sim::RunOptions& run);

  /// Completes the file, after the run has ended.
  /// @return Whether it is complete; otherwise it was reported.
  bool finish();

 private:
  const std::vector<std::unique_ptr<Simulation>>& worlds_;
  sim::RecordingWriter writer_;
};

}  // namespace pongsim::cli
