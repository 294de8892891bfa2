#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/export.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Something in a running world that has fields.
struct Signal {
  enum class Kind {
    /// The messages of a topic; its fields are paths such as `pose.position.x`, and `min(ranges)`, `max(ranges)`,
    /// `mean(ranges)` and `size(ranges)` of a list of numbers.
    kTopic,
    /// Pose of a model, link or actor in the world frame: x, y, z [m], roll, pitch, yaw [rad].
    kPose,
    /// Velocity of a link, or of a model's canonical link, in the world frame: x, y, z, speed [m/s], and roll, pitch,
    /// yaw: the angular velocity about x, y, z [rad/s].
    kVelocity,
    /// First axis of a joint: position [rad or m], velocity [rad/s or m/s].
    kJoint,
    /// Contact of two things: touching (1 or 0), points (their number), depth [m], force [N] (sum over the points).
    kContact,
  };
  Kind kind = Kind::kTopic;
  /// A topic; "model", "model::link" or "actor"; "model::joint"; of a contact "model", "model::link" or
  /// "model::link::collision".
  std::string name;
  /// What a contact is with; empty: anything.
  std::string other = {};
};

/// Values of a field in an earlier run, by time; at other times they are interpolated.
struct RecordedValues {
  /// Increasing [s].
  std::vector<double> times;
  std::vector<double> values;
};

/// A condition on one field.
struct Criterion {
  enum class Relation {
    kEquals,
    kDiffers,
    kAbove,
    kAtLeast,
    kBelow,
    kAtMost,
    /// Within `other` of `number`.
    kNear,
    /// From `number` to `other`.
    kBetween,
    /// Has `text` in it.
    kContains,
    /// Within `other` of the value of a recorded run at the same time.
    kRecorded,
  };
  std::string field;
  Relation relation = Relation::kEquals;
  double number = 0;
  double other = 0;
  /// Instead of a number, for kEquals, kDiffers and kContains; unset: the number counts.
  std::optional<std::string> text = {};
  /// Whether `number` is a truth value, 1 or 0, and shown as one.
  bool isTruth = false;
  /// For kRecorded; not null then.
  std::shared_ptr<const RecordedValues> recorded = {};
};

/// A signal that meets all criteria; without criteria: a message that arrives, a contact that is there.
struct Event {
  Signal signal;
  std::vector<Criterion> criteria = {};
};

/// What is expected of a run. Its window of time begins `from` after the start, or after the event `after`, and ends at
/// `to`, counted in the same way, or with the run. Both ends belong to it. If `from` equals `to`, the first value from
/// then on counts.
struct Expectation {
  enum class Mode {
    /// The event comes within the window, and where `hold` is above zero stays for that long.
    kEventually,
    /// Each value in the window meets the criteria, and there is one.
    kAlways,
    /// No value in the window meets the criteria.
    kNever,
    /// All events come within the window, each at the time of the one before it or later.
    kInOrder,
  };
  Mode mode = Mode::kEventually;
  /// One event; for kInOrder one or more.
  std::vector<Event> events;
  /// The window begins when it first comes, which it must.
  std::optional<Event> after = {};
  /// For kAlways and kNever: the window ends just before it first comes, which it must, at the latest at `to`.
  std::optional<Event> until = {};
  Time from{0};
  std::optional<Time> to = {};
  Time hold{0};
};

/// @return "/wall/touched: data = true".
PONGSIM_API std::string describe(const Event& event);

/// @return "eventually /wall/touched: data = true, within 20 s".
PONGSIM_API std::string describe(const Expectation& expectation);

/// How an expectation stands.
struct Verdict {
  enum class State { kPending, kMet, kFailed };
  State state = State::kPending;
  /// When it was decided.
  Time time{0};
  std::string expected;
  /// What was seen instead, or when it was met: one line.
  std::string seen;
  /// The field of its first event that a plot shows, with at most some hundred of its values, by time [s].
  std::string field;
  std::vector<double> times;
  std::vector<double> values;
};

}  // namespace pongsim
