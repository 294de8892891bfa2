#include "sim/inputs/replay.hh"

#include <algorithm>
#include <filesystem>

#include "sim/api/access.hh"
#include "sim/inputs/inside.hh"

namespace pongsim::sim {

Replay::Replay(const Tape& tape, Simulation& simulation, bool paused)
    : tape_(tape),
      simulation_(simulation),
      control_(paused),
      history_(simulation, false),
      services_(simulation, control_, history_, [](const std::filesystem::path&) {}),
      serverServices_(simulation.transport(), {std::string(simulation.world().name())}, [] {}),
      gate_(simulation.transport(), transport::InputGate::Use::kReplace) {}

/// @return False at the end; otherwise `kind` is what comes next, counted as done.
bool Replay::next(Passage::Kind& kind) {
  while (passage_ < tape_.passages.size()) {
    const Passage& passage = tape_.passages[passage_];
    if (run_ == passage.runs.size()) {
      ++passage_;
      run_ = intake_ = folder_ = change_ = 0;
      continue;
    }
    if (done_ == passage.runs[run_].count) {
      ++run_;
      done_ = 0;
      continue;
    }
    ++done_;
    kind = passage.runs[run_].kind;
    return true;
  }
  return false;
}

bool Replay::advance() {
  using enum Passage::Kind;
  missing_.clear();
  for (Passage::Kind kind{}; next(kind);) {
    switch (kind) {
      case kIntake: {
        const Passage& passage = tape_.passages[passage_];
        if (intake_ < passage.intakes.size()) gate_.handOver(passage.intakes[intake_++]);
        break;
      }
      case kFolder: {
        const Passage& passage = tape_.passages[passage_];
        if (folder_ < passage.folders.size()) simulation_.addResourceFolder(passage.folders[folder_++]);
        break;
      }
      case kChange: {
        const Passage& passage = tape_.passages[passage_];
        if (change_ < passage.changes.size()) {
          Inside::access(simulation_).outsideChanges.due.push_back(passage.changes[change_++]);
        }
        break;
      }
      case kDispatch:
        dispatch();
        break;
      case kServe:
        serve();
        break;
      case kStep:
        dispatch();
        step(false);
        return true;
      case kPausedStep:
        step(true);
        dispatch();
        return true;
      case kAdvance:
        step(false);
        return true;
      case kPausedAdvance:
        step(true);
        return true;
    }
  }
  return false;
}

void Replay::dispatch() {
  simulation_.transport().dispatch();
  takeMissing();
}

void Replay::serve() {
  gate_.serve();
  takeMissing();
}

void Replay::takeMissing() {
  missing_.insert(missing_.end(), gate_.missing.begin(), gate_.missing.end());
  gate_.missing.clear();
}

void Replay::step(bool paused) {
  Inside::advance(simulation_, paused ? Time::zero() : simulation_.stepSize());
  Inside::access(simulation_).outsideChanges.due.clear();
  ++advances_;
  if (!paused) {
    ++steps_;
    control_.stepped(simulation_.time());
  }
  while (hashPassage_ < tape_.passages.size() && hash_ == tape_.passages[hashPassage_].hashes.size()) {
    ++hashPassage_;
    hash_ = 0;
  }
  if (hashPassage_ == tape_.passages.size()) return;
  isAsRecorded_ = tape_.passages[hashPassage_].hashes[hash_++] == quickHash(Inside::access(simulation_));
}

const StateValues* Replay::recordedState() const {
  const auto found = std::ranges::lower_bound(tape_.states, advances_, {}, &RecordedState::steps);
  return found != tape_.states.end() && found->steps == advances_ ? &found->values : nullptr;
}

}  // namespace pongsim::sim
