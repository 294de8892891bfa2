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

/// Writes the state of a world step by step. The simulation's thread copies what moves; a thread of its own makes
/// messages of that, and hands them to the writer.
class StateRecorder {
 public:
  /// @param writer Must outlive it; others may write to it, too.
  /// @param topic Of the states, "/world/W/changed_state".
  /// @param cameOrWent Called on its thread with each state in which somebody has, an ignition.msgs.SerializedStepMap.
  StateRecorder(const Scene& scene, Writer& writer, std::string topic, std::function<void(const Message&)> cameOrWent);
  ~StateRecorder();
  StateRecorder(const StateRecorder&) = delete;
  StateRecorder& operator=(const StateRecorder&) = delete;

  /// @return Whether somebody has come or gone since the last state that was recorded.
  bool hasNews() const { return watch_.hasNews(); }

  /// Records the state that is now. Waits only where the writer is 64 states behind.
  /// @throws Failure where the writer does.
  void record();

  /// Waits until all has been handed to the writer.
  /// @throws Failure likewise.
  void finish();

 private:
  void work();

  StateWatch watch_;
  Writer& writer_;
  const std::string topic_;
  const std::function<void(const Message&)> cameOrWent_;
  std::mutex mutex_;
  std::condition_variable given_, taken_;
  /// Those that wait, and those that may be filled.
  std::deque<std::unique_ptr<StateSnapshot>> waiting_;
  std::vector<std::unique_ptr<StateSnapshot>> free_;
  bool isFinishing_ = false;
  std::optional<Failure> failure_;
  std::thread thread_;
};

}  // namespace pongsim::log
