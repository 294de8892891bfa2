#pragma once

#include <chrono>
#include <fstream>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "log/record/record_folder.hh"
#include "log/record/resources.hh"
#include "log/record/state_recorder.hh"
#include "log/record/topic_recorder.hh"
#include "log/record/worlds_folder.hh"
#include "log/tlog/tlog_writer.hh"
#include "pongsim/program/log_sink.hh"
#include "pongsim/system.hh"

namespace pongsim::log {

/// Fortress's LogRecord: records the world, its state step by step, and topics into a folder.
class RecordSystem final : public System {
 public:
  ~RecordSystem() override;
  void declare(Declaration& declaration) override;
  void configure(const SystemContext& context) override;
  void preUpdate(const StepInfo& info) override;
  void postUpdate(const StepInfo& info) override;
  void reset() override;
  void finish() override;

 private:
  void start(const SystemContext& context);
  void startConsoleLog();
  std::string worldText(const SystemContext& context);
  void publishClock(Time time);
  /// Completes the recording, or notes why that failed.
  void end();
  void complete();
  /// Stops recording, and notes why.
  void note(const std::exception& why);

  std::string path_, zipPath_;
  std::vector<std::string> topics_;
  bool resources_ = false, compress_ = false, overwrite_ = false, keepsExisting_ = false;
  double period_ = 0;

  const Logger* log_ = nullptr;
  /// Set if other worlds are recorded in parallel.
  std::shared_ptr<WorldsFolder> worlds_;
  RecordFolder folder_;
  std::string sdfTopic_;
  /// An ignition.msgs.StringMsg, until it has been written.
  std::string sdf_;
  std::ofstream console_;
  std::mutex consoleMutex_;
  std::optional<LogSink> sink_;
  std::optional<ResourceCopies> copies_;
  std::optional<Publisher> clock_;
  std::optional<Publisher> sdfPublisher_;
  bool isRecording_ = false;
  /// Why the recording is not complete.
  std::optional<Failure> failure_;
  std::optional<Time> last_;
  // last: both recorders write to the writer, and are destroyed before it
  std::unique_ptr<TlogWriter> writer_;
  std::optional<TopicRecorder> topicRecorder_;
  std::optional<StateRecorder> stateRecorder_;
};

}  // namespace pongsim::log
