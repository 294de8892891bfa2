#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "pongsim/expect/expectation.hh"

namespace pongsim::sim {

/// The temporal logic of an expectation: from when its events hold to when it is met or failed. It knows no worlds,
/// only times and truth values, and it gets them in the order of time.
class Evaluation {
 public:
  enum class Role { kEvent, kAfter, kUntil };
  enum class Reason {
    kNone,
    /// `after` did not come, so the window never began.
    kNoStart,
    /// The window ended without what must come.
    kTooLate,
    /// A value was not as it must be.
    kViolated,
    /// `until` did not come.
    kNoEnd,
    /// There was no value in the window.
    kNoValue,
  };

  /// @param expectation Must outlive this.
  explicit Evaluation(const Expectation& expectation);

  /// A value was seen.
  /// @param event Number of the event, for kEvent.
  /// @param holds Whether it meets the event's criteria.
  /// @return Whether the value counts: it is in the window of an undecided expectation.
  bool see(Role role, std::size_t event, Time time, bool holds);

  /// All values before `time` have been seen.
  void advance(Time time);

  /// The run is over, and all values have been seen.
  void end(Time time);

  Verdict::State state() const { return state_; }
  bool isDecided() const { return state_ != Verdict::State::kPending; }
  Time decidedAt() const { return decidedAt_; }
  Reason reason() const { return reason_; }
  /// When the events of kInOrder that have come in order came.
  const std::vector<Time>& reached() const { return reached_; }
  /// When an event of kInOrder came first, in order or not.
  std::optional<Time> cameFirst(std::size_t event) const { return first_[event]; }

 private:
  void meet(Time time);
  void fail(Time time, Reason reason);
  bool isIn(Time time) const;
  std::optional<Time> deadline() const;
  void seeOne(Time time, bool holds);
  void seeSequence(std::size_t event, Time time, bool holds);
  void judgeSteady(Time time);

  const Expectation* expectation_;
  Verdict::State state_ = Verdict::State::kPending;
  Time decidedAt_{0};
  Reason reason_ = Reason::kNone;
  /// From which `from` and `to` count; unset until `after` comes.
  std::optional<Time> origin_;
  /// Since when the event holds, for `hold`.
  std::optional<Time> holdsSince_;
  /// A violation that counts unless `until` comes at the same time.
  std::optional<Time> violation_;
  bool hasValue_ = false;
  std::vector<Time> reached_;
  std::vector<std::optional<Time>> first_;
};

}  // namespace pongsim::sim
