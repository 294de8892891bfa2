#include "cli/run/input_recording.hh"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "shared/program/console.hh"
#include "sim/inputs/input_recorder.hh"

namespace pongsim::cli {

void InputRecording::addTo(sim::RunOptions& run) {
  run.observe = [this](Simulation& world) {
    const auto found = std::ranges::find(worlds_, &world, &std::unique_ptr<Simulation>::get);
    return std::make_unique<sim::InputRecorder>(world, static_cast<std::uint32_t>(found - worlds_.begin()), writer_);
  };
  run.stepped = [this, before = std::move(run.stepped)](Simulation& world) {
    return !writer_.hasFailed() && (!before || before(world));
  };
}

bool InputRecording::finish() {
  const Outcome<void> finished = writer_.finish();
  if (!finished) sayError(finished.error);
  return static_cast<bool>(finished);
}

}  // namespace pongsim::cli
