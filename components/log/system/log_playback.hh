#pragma once

#include <memory>
#include <optional>
#include <string>

#include "log/playback/played_files.hh"
#include "log/playback/replay.hh"
#include "log/tlog/tlog_reader.hh"
#include "pongsim/system.hh"

namespace pongsim::log {

/// Fortress's LogPlayback: moves everything to its recorded pose, instead of physics.
class PlaybackSystem final : public System {
 public:
  void declare(Declaration& declaration) override;
  void configure(const SystemContext& context) override;
  void preUpdate(const StepInfo& info) override;
  void postUpdate(const StepInfo& info) override;
  void worldChanged() override;
  void reset() override;

 private:
  void open(const SystemContext& context);
  void publishRange();
  void goTo(Time time);
  void pauseAtEnd(const StepInfo& info);

  std::string path_;
  std::string controlService_;
  const Logger* log_ = nullptr;
  std::optional<Node> node_;
  std::optional<StatePlayer> player_;
  std::unique_ptr<PlayedFiles> files_;
  std::unique_ptr<TlogReader> reader_;
  std::unique_ptr<Replay> replay_;
  /// Current time of the replay.
  Time at_{0};
  PendingRequest pause_;
  Publisher range_;
};

}  // namespace pongsim::log
