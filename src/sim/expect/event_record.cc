#include "sim/expect/event_record.hh"

#include <cmath>

namespace pongsim::sim {

namespace {

/// Of a plot: more than a terminal has columns.
constexpr std::size_t kMostValues = 512;

}  // namespace

EventRecord::EventRecord(const Event& event) : event_(&event), isAngle_(event.criteria.size(), false) {}

bool EventRecord::holdsFor(std::span<const FieldValue> values, Time time) {
  miss_ = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    miss_ += missOf(event_->criteria[i], values[i], time, isAngle_[i] != 0);
  }
  return miss_ == 0;
}

void EventRecord::count(std::span<const FieldValue> values, Time time) {
  last_.time = time;
  last_.values.assign(values.begin(), values.end());
  if (count_ == 0 || miss_ < leastMiss_) {
    leastMiss_ = miss_;
    closest_ = last_;
  }
  if (!values.empty() && values[0].number && count_ % stride_ == 0) keep(*values[0].number, time);
  ++count_;
}

/// Keeps each second value, then each fourth and so on, as the run gets longer.
void EventRecord::keep(double value, Time time) {
  if (times_.size() == kMostValues) {
    for (std::size_t i = 0; 2 * i < kMostValues; ++i) {
      times_[i] = times_[2 * i];
      values_[i] = values_[2 * i];
    }
    times_.resize(kMostValues / 2);
    values_.resize(kMostValues / 2);
    stride_ *= 2;
    if (count_ % stride_ != 0) return;
  }
  times_.push_back(toSeconds(time));
  values_.push_back(value);
}

std::string EventRecord::wordsOf(const Look& look) const {
  std::string words;
  for (std::size_t i = 0; i < look.values.size(); ++i) {
    words += (i > 0 ? ", " : "") + sim::wordsOf(event_->criteria[i], look.values[i], look.time);
  }
  if (words.empty()) words = "a message";
  return words + " at " + secondsText(look.time);
}

std::string EventRecord::last() const { return count_ == 0 ? "" : wordsOf(last_); }

std::string EventRecord::summary() const {
  const bool isTopic = event_->signal.kind == Signal::Kind::kTopic;
  if (count_ == 0) return isTopic ? "no message came" : "it was not looked at in that time";
  const std::string all = isTopic ? std::to_string(count_) + (count_ == 1 ? " message" : " messages") : "";
  std::string words;
  // a text and a truth value are not near to another
  const bool isNumber = !event_->criteria.empty() && !event_->criteria[0].text && !event_->criteria[0].isTruth;
  if (isNumber && std::isfinite(leastMiss_) && closest_.time != last_.time) {
    words = wordsOf(closest_) + " came nearest; ";
  }
  words += wordsOf(last_) + " was the last" + (all.empty() ? "" : " of " + all);
  return words;
}

void EventRecord::plot(Verdict& verdict) const {
  if (event_->criteria.empty() || times_.size() < 2) return;
  verdict.field = event_->criteria[0].field;
  verdict.times = times_;
  verdict.values = values_;
}

}  // namespace pongsim::sim
