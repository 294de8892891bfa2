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

/// A message to publish before the step that begins at this simulated time.
struct RecordedCommand {
  Time time{0};
  std::string topic;
  /// "ignition.msgs.Double"
  std::string type;
  /// In the format of `pongsim topic -p`.
  std::string text;
};

/// A battery of a model. Recordings do not name batteries: those of a time follow each other in this order.
struct RecordedBattery {
  std::string model;
  std::string name;
};

/// Differences between a run and Fortress's recording of one model, link, joint or battery.
struct Deviation {
  /// Largest difference of positions [m], of positions of a joint's axes [rad or m], or of charges (0 to 1).
  double largest = 0;
  /// Time of the largest difference.
  Time when{0};
  /// Largest angle between the rotations [rad].
  double largestAngle = 0;
  /// The differences at the last sample.
  double last = 0;
  double lastAngle = 0;
  /// Length of the recorded path [m].
  double way = 0;
};

/// One line of a recording: the state of a model, link, joint or battery.
struct RecordedRow {
  Time time{0};
  /// "model", "link", "joint" or "battery".
  std::string what;
  /// Without the name of the world: "submarine::body".
  std::string name;
  /// Position [m] and rotation (w, x, y, z) of models and links, positions of a joint's axes, charge (0 to 1).
  std::vector<double> values;
};

/// Reads a recording of Fortress: lines `t,what,name,v0,...`.
std::vector<RecordedRow> readRecording(const std::filesystem::path& file);

/// A run of one of Fortress's worlds, compared with its recording.
class Replay {
 public:
  /// Loads a world. The test fails if it can't be loaded; it is not skipped: see `isHere`.
  /// @param world File relative to the folder of Fortress's worlds: "test/conveyor.sdf".
  /// @param batteries Batteries to compare; empty: those of the recording are ignored.
  explicit Replay(const std::string& world, std::vector<RecordedCommand> commands = {},
                  std::vector<RecordedBattery> batteries = {});

  /// @return Whether this machine has Fortress's worlds and recordings; skip the test if it has not.
  static bool isHere();

  /// Runs to the time of the last line.
  /// @param atEach Called at the time of each line, for further comparisons.
  void run(const std::function<void(const RecordedRow&)>& atEach = {});

  /// @param whatAndName "model NAME", "link NAME", "joint NAME" or "battery NAME". The test fails if the recording has
  /// none.
  const Deviation& of(const std::string& whatAndName) const;
  const std::map<std::string, Deviation>& all() const { return deviations_; }
  /// Recorded entities that the world lacks: "model NAME".
  const std::vector<std::string>& missing() const { return missing_; }
  Simulation& simulation() { return *simulation_; }
  const std::vector<RecordedRow>& rows() const { return rows_; }

 private:
  void compare(const RecordedRow& row);
  void compareBattery(const RecordedRow& row);

  std::vector<RecordedRow> rows_;
  std::vector<RecordedCommand> commands_;
  std::vector<RecordedBattery> batteries_;
  /// The last published charge of each battery.
  std::map<std::string, double> charges_;
  /// Number of lines of batteries so far at `batteryTime_`.
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
