#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "log/playback/played_files.hh"
#include "log/playback/recorded_state.hh"
#include "log/tlog/tlog_reader.hh"
#include "pongsim/state/state_player.hh"
#include "pongsim/system.hh"

namespace pongsim::log {

/// Lets a world be what a log says of a time. Models that the log has and the world has not are inserted, those that
/// the log has not are removed; all links and joints are put where it has them.
class Replay {
 public:
  /// All references must outlive it.
  Replay(const TlogReader& reader, const PlayedFiles& files, const SystemContext& context);

  /// @return Of the log's states; nothing where it has none.
  const std::optional<TimeRange>& range() const { return range_; }

  /// Reads on to a time, or all anew where that lies behind, and asks for models to come and go.
  void goTo(Time time);

  /// Puts what has changed since the last call where the log has it.
  void place();

  /// Models have come or gone: all is put where the log has it with the next call.
  void worldChanged() { isMatched_ = false; }

 private:
  void editModels();
  void match();
  void placeJoint(std::uint64_t joint, Time time);
  Pose poseInWorld(std::uint64_t entity) const;

  const TlogReader& reader_;
  const PlayedFiles& files_;
  World& world_;
  WorldEdits& edits_;
  const Logger& log_;
  StatePlayer player_;
  std::vector<std::string> topics_;
  std::optional<TimeRange> range_;

  RecordedState state_;
  /// Up to which it has been read.
  std::optional<std::int64_t> readTo_;
  bool isMatched_ = false;
  /// By the ids of the recording.
  std::unordered_map<std::uint64_t, Link> links_;
  std::unordered_map<std::uint64_t, Joint> joints_;
  struct Axes {
    std::vector<double> positions;
    Time time{0};
  };
  std::unordered_map<std::uint64_t, Axes> lastAxes_;
};

}  // namespace pongsim::log
