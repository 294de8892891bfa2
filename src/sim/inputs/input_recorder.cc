#include "sim/inputs/input_recorder.hh"

#include <utility>

#include "pongsim/log.hh"
#include "sim/api/access.hh"
#include "sim/inputs/inside.hh"
#include "sim/inputs/recording_writer.hh"

namespace pongsim::sim {

namespace {

/// Steps between two writes: what a killed run loses.
constexpr std::size_t kStepsPerPassage = 100;
/// Bytes of inputs that are written earlier.
constexpr std::size_t kMostTaken = 64 << 10;
/// Steps between two records of the whole state.
constexpr std::uint64_t kStepsPerState = 1000;

std::size_t sizeOf(const transport::Intake& intake) {
  std::size_t size = 0;
  for (const auto& message : intake.messages) size += message.bytes.size();
  for (const auto& request : intake.requests) size += request.bytes.size();
  return size;
}

}  // namespace

InputRecorder::InputRecorder(Simulation& simulation, std::uint32_t world, RecordingWriter& writer)
    : simulation_(simulation), writer_(writer), gate_(simulation.transport(), transport::InputGate::Use::kNote) {
  passage_.world = world;
  Inside::access(simulation).outsideChanges.isNoting = true;
}

InputRecorder::~InputRecorder() {
  Inside::access(simulation_).outsideChanges.isNoting = false;
  addPending();
  if (steps_ > 0) recordState();
  flush();
  writer_.write(frameWith(FrameKind::kWorldEnd, WorldEnd{passage_.world, simulation_.stateHash()}));
}

void InputRecorder::add(Passage::Kind kind) {
  const bool isListed =
      kind == Passage::Kind::kIntake || kind == Passage::Kind::kFolder || kind == Passage::Kind::kChange;
  if (!isListed && !passage_.runs.empty() && passage_.runs.back().kind == kind) {
    ++passage_.runs.back().count;
  } else {
    passage_.runs.push_back({kind, 1});
  }
}

void InputRecorder::addPending() {
  if (pending_) add(*std::exchange(pending_, std::nullopt));
}

void InputRecorder::addIntake() {
  if (gate_.intake.isEmpty()) return;
  taken_ += sizeOf(gate_.intake);
  passage_.intakes.push_back(std::exchange(gate_.intake, {}));
  add(Passage::Kind::kIntake);
}

void InputRecorder::dispatched() {
  const bool endsPausedStep = pending_ == Passage::Kind::kPausedAdvance;
  if (!endsPausedStep) addPending();
  addIntake();
  if (endsPausedStep) {
    pending_.reset();
    add(Passage::Kind::kPausedStep);
  } else {
    pending_ = Passage::Kind::kDispatch;
  }
}

void InputRecorder::served() {
  addPending();
  addIntake();
  add(Passage::Kind::kServe);
}

void InputRecorder::advanced(bool paused) {
  if (pending_ == Passage::Kind::kPausedAdvance) addPending();
  std::vector<OutsideChange>& changes = Inside::access(simulation_).outsideChanges.noted;
  if (!changes.empty()) {
    // a dispatch before this step comes before them, and changes nothing of them
    for (OutsideChange& change : changes) {
      taken_ += change.source.text.size();
      passage_.changes.push_back(std::move(change));
      add(Passage::Kind::kChange);
    }
    changes.clear();
  }
  if (paused) {
    addPending();
    pending_ = Passage::Kind::kPausedAdvance;
  } else if (pending_ == Passage::Kind::kDispatch) {
    pending_.reset();
    add(Passage::Kind::kStep);
  } else {
    addPending();
    add(Passage::Kind::kAdvance);
  }
  noteUnrecorded();
  if (!paused) ++movingSteps_;
  passage_.hashes.push_back(quickHash(Inside::access(simulation_)));
  if (++steps_ == nextState_) {
    recordState();
    nextState_ = (steps_ / kStepsPerState + 1) * kStepsPerState;
  }
  if (passage_.hashes.size() >= kStepsPerPassage || taken_ >= kMostTaken) flush();
}

void InputRecorder::folderAdded(const std::filesystem::path& folder) {
  addPending();
  passage_.folders.push_back(folder.string());
  add(Passage::Kind::kFolder);
}

/// Notes the first change that is not recorded.
void InputRecorder::noteUnrecorded() {
  if (hasUnrecorded_ || Inside::access(simulation_).outsideChanges.unnoted == 0) return;
  hasUnrecorded_ = true;
  Logger("inputs").warning(
      "a system that connects the world with the outside has changed it without a message or request: this is not "
      "recorded, and a replay differs from here on");
  writer_.write(frameWith(FrameKind::kUnrecordedChange, UnrecordedChange{passage_.world, movingSteps_}));
}

void InputRecorder::recordState() {
  writer_.write(frameWith(FrameKind::kState,
                          RecordedState{passage_.world, steps_, StateValues::of(Inside::access(simulation_))}));
}

void InputRecorder::flush() {
  writer_.write(frameWith(FrameKind::kPassage, passage_));
  const std::uint32_t world = std::exchange(passage_, {}).world;
  passage_.world = world;
  taken_ = 0;
}

}  // namespace pongsim::sim
