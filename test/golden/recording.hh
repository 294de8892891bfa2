#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "pongsim/simulation.hh"
#include "pongsim/types.hh"

namespace pongsim::test {

/// A message that is published before the step that begins at that simulated time.
struct RecordedCommand {
  Time time{0};
  std::string topic;
  /// "ignition.msgs.Double"
  std::string type;
  /// As `pongsim topic -p` takes it.
  std::string text;
};

/// A battery of a model. Recordings name none: they have a line for each, in this order.
struct RecordedBattery {
  std::string model;
  std::string name;
};

/// How far a run was from what Fortress recorded of one model, link or joint.
struct Deviation {
  /// Largest distance of positions [m], of the positions of a joint's axes [rad or m], or of states of charge.
  double largest = 0;
  /// When that was.
  Time when{0};
  /// Largest angle between the rotations [rad].
  double largestAngle = 0;
  /// Those of the last sample.
  double last = 0;
  double lastAngle = 0;
  /// Way that the recorded positions go [m].
  double way = 0;
};

/// One line of a recording: the state of a model, link, joint or battery.
struct RecordedRow {
  Time time{0};
  /// "model", "link", "joint" or "battery".
  std::string what;
  /// Without the world's: "submarine::body".
  std::string name;
  /// Position [m] and rotation (w, x, y, z) of models and links, positions of a joint's axes, charge (0 to 1).
  std::vector<double> values;
};

/// Reads a recording of Fortress: lines `t,what,name,v0,...`.
std::vector<RecordedRow> readRecording(const std::filesystem::path& file);

/// What a run of one of Fortress's worlds gave beside its recording.
class Replay {
 public:
  /// Runs `world`, a file below the folder of Fortress's worlds as "test/conveyor.sdf", beside the recording of the
  /// same name. Fails the test where it can't be loaded, and skips nothing: see `isHere`.
  /// @param batteries Those to compare, by what they publish; none: the lines of batteries are passed over.
  explicit Replay(const std::string& world, std::vector<RecordedCommand> commands = {},
                  std::vector<RecordedBattery> batteries = {});

  /// @return Whether Fortress's worlds and recordings are here; skip the test where they are not.
  static bool isHere();

  /// Runs to the last line.
  /// @param atEach Called when the run stands at a line's time, for what a test looks at besides.
  void run(const std::function<void(const RecordedRow&)>& atEach = {});

  /// Of "model NAME", "link NAME", "joint NAME" or "battery NAME". A test fails where the recording has no such thing.
  const Deviation& of(const std::string& whatAndName) const;
  const std::map<std::string, Deviation>& all() const { return deviations_; }
  /// What the recording has and the world has not, as "model NAME".
  const std::vector<std::string>& missing() const { return missing_; }
  Simulation& simulation() { return *simulation_; }
  const std::vector<RecordedRow>& rows() const { return rows_; }

 private:
  void compare(const RecordedRow& row);
  void compareBattery(const RecordedRow& row);

  std::vector<RecordedRow> rows_;
  std::vector<RecordedCommand> commands_;
  std::vector<RecordedBattery> batteries_;
  /// What each has published last.
  std::map<std::string, double> charges_;
  /// Of the lines at a time, how many were batteries.
  std::size_t batteryCount_ = 0;
  Time batteryTime_{0};
  std::unique_ptr<Simulation> simulation_;
  std::map<std::string, Publisher> publishers_;
  std::vector<Subscription> subscriptions_;
  std::map<std::string, Deviation> deviations_;
  std::map<std::string, Vector3> lastPositions_;
  std::vector<std::string> missing_;
};

}  // namespace pongsim::test
