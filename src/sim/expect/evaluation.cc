#include "sim/expect/evaluation.hh"

namespace pongsim::sim {

using Mode = Expectation::Mode;
using State = Verdict::State;

Evaluation::Evaluation(const Expectation& expectation) : expectation_(&expectation), first_(expectation.events.size()) {
  if (!expectation.after) origin_ = Time(0);
}

void Evaluation::meet(Time time) {
  state_ = State::kMet;
  decidedAt_ = time;
}

void Evaluation::fail(Time time, Reason reason) {
  state_ = State::kFailed;
  decidedAt_ = time;
  reason_ = reason;
}

std::optional<Time> Evaluation::deadline() const {
  if (!origin_ || !expectation_->to) return std::nullopt;
  return *origin_ + *expectation_->to;
}

bool Evaluation::isIn(Time time) const {
  if (!origin_ || time < *origin_ + expectation_->from) return false;
  const bool isMoment = expectation_->to == expectation_->from;
  return isMoment || !deadline() || time <= *deadline();
}

bool Evaluation::see(Role role, std::size_t event, Time time, bool holds) {
  advance(time);
  if (isDecided()) return false;
  if (role == Role::kAfter) {
    if (!origin_ && holds) origin_ = time;
    return true;
  }
  if (!isIn(time)) return false;
  if (role == Role::kUntil) {
    // a violation at an earlier time has been judged by `advance`
    if (holds) meet(time);
  } else if (expectation_->mode == Mode::kInOrder) {
    seeSequence(event, time, holds);
  } else {
    seeOne(time, holds);
  }
  return true;
}

void Evaluation::seeOne(Time time, bool holds) {
  if (expectation_->mode == Mode::kEventually) {
    if (!holds) {
      holdsSince_.reset();
    } else if (!holdsSince_) {
      holdsSince_ = time;
      if (expectation_->hold == Time(0)) meet(time);
    }
    return;
  }
  hasValue_ = true;
  const bool isRight = holds == (expectation_->mode == Mode::kAlways);
  const bool isMoment = expectation_->to == expectation_->from && !expectation_->until;
  if (!isRight && expectation_->until) {
    if (!violation_) violation_ = time;
  } else if (!isRight) {
    fail(time, Reason::kViolated);
  } else if (isMoment) {
    meet(time);
  }
}

void Evaluation::seeSequence(std::size_t event, Time time, bool holds) {
  if (!holds) return;
  if (!first_[event]) first_[event] = time;
  if (event != reached_.size()) return;
  reached_.push_back(time);
  if (reached_.size() == first_.size()) meet(time);
}

void Evaluation::advance(Time time) {
  if (isDecided()) return;
  if (violation_ && time > *violation_) return fail(*violation_, Reason::kViolated);
  const std::optional<Time> last = deadline();
  if (holdsSince_ && expectation_->hold > Time(0)) {
    const Time done = *holdsSince_ + expectation_->hold;
    if (time >= done && (!last || done <= *last)) return meet(done);
  }
  if (!last || time <= *last) return;
  if (expectation_->mode == Mode::kAlways || expectation_->mode == Mode::kNever) return judgeSteady(*last);
  fail(*last, Reason::kTooLate);
}

/// At the end of the window of `always` and `never`.
void Evaluation::judgeSteady(Time time) {
  const bool isMoment = expectation_->to == expectation_->from;
  if (expectation_->until) return fail(time, Reason::kNoEnd);
  // the first value after a moment counts
  if (isMoment && !hasValue_) return;
  if (expectation_->mode == Mode::kAlways && !hasValue_) return fail(time, Reason::kNoValue);
  meet(time);
}

void Evaluation::end(Time time) {
  advance(time);
  if (isDecided()) return;
  if (violation_) return fail(*violation_, Reason::kViolated);
  if (!origin_) return fail(time, Reason::kNoStart);
  if (expectation_->until) return fail(time, Reason::kNoEnd);
  if (expectation_->mode == Mode::kNever) return meet(time);
  if (expectation_->mode == Mode::kAlways) {
    return hasValue_ ? meet(time) : fail(time, Reason::kNoValue);
  }
  fail(time, Reason::kTooLate);
}

}  // namespace pongsim::sim
