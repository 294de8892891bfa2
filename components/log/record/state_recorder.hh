#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "log/store/failure.hh"
#include "log/store/writer.hh"
#include "pongsim/state/state_changes.hh"

namespace pongsim::log {

/// Records the state of a world step by step. The simulation's thread copies what moves; a thread of its own serializes
/// it and passes it to the writer.
class StateRecorder {
 public:
  /// @param writer Must outlive it; others can write to it too.
  /// @param topic Topic of the states, "/world/W/changed_state".
  /// @param entitiesChanged Called on its thread with each state that adds or removes entities, an
  /// ignition.msgs.SerializedStepMap.
  StateRecorder(const Scene& scene, Writer& writer, std::string topic,
                std::function<void(const Message&)> entitiesChanged);
  ~StateRecorder();
  StateRecorder(const StateRecorder&) = delete;
  StateRecorder& operator=(const StateRecorder&) = delete;

  /// @return Whether entities have been added or removed since the last recorded state.
  bool hasNews() const { return watch_.hasNews(); }

  /// Records the current state. Blocks only if the writer is 64 states behind.
  /// @throws Failure if the writer or `entitiesChanged` has failed; the same below.
  void record();

  /// Waits until everything has been passed to the writer.
  void finish();

 private:
  void work();

  StateWatch watch_;
  Writer& writer_;
  const std::string topic_;
  const std::function<void(const Message&)> entitiesChanged_;
  std::mutex mutex_;
  std::condition_variable hasWork_, hasRoom_;
  /// Snapshots waiting to be written, and free ones.
  std::deque<std::unique_ptr<StateSnapshot>> waiting_;
  std::vector<std::unique_ptr<StateSnapshot>> free_;
  bool isFinishing_ = false;
  std::optional<Failure> failure_;
  std::thread thread_;
};

}  // namespace pongsim::log
