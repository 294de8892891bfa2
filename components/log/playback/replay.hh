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

/// Makes a world match a log at a given time. Inserts models that are only in the log, removes models that are only in
/// the world, and places all links and joints.
class Replay {
 public:
  /// All references must outlive it.
  Replay(const TlogReader& reader, const PlayedFiles& files, const SystemContext& context);

  /// @return Time range of the log's states; nothing if it has none.
  const std::optional<TimeRange>& range() const { return range_; }

  /// Reads on to a time, or from the start again if the time has passed, and requests the insertion and removal of
  /// models.
  void goTo(Time time);

  /// Moves everything that has changed since the last call to its pose in the log.
  void place();

  /// Call when models have been added or removed: the next call places everything again.
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
  /// The time up to which the log has been read.
  std::optional<std::int64_t> readTo_;
  bool isMatched_ = false;
  /// Keyed by the recording's ids.
  std::unordered_map<std::uint64_t, Link> links_;
  std::unordered_map<std::uint64_t, Joint> joints_;
  struct Axes {
    std::vector<double> positions;
    Time time{0};
  };
  std::unordered_map<std::uint64_t, Axes> lastAxes_;
};

}  // namespace pongsim::log
