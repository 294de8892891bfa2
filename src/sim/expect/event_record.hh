#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pongsim/expect/expectation.hh"
#include "sim/expect/criterion.hh"

namespace pongsim::sim {

/// What was seen of an event: for messages about it, and for a plot of its first field.
class EventRecord {
 public:
  /// @param event Must outlive this.
  explicit EventRecord(const Event& event);

  /// Full turns of this field do not count.
  void setAngle(std::size_t criterion) { isAngle_[criterion] = true; }

  /// @param values One for each criterion.
  /// @return Whether they meet all criteria.
  bool holdsFor(std::span<const FieldValue> values, Time time);

  /// Counts the values of the last call of `holdsFor`.
  void count(std::span<const FieldValue> values, Time time);

  /// @return Number of values so far.
  std::size_t size() const { return count_; }

  /// @return "x = 4.93 at 3.2 s"; nothing if there was no value.
  std::string last() const;

  /// @return "x = 4.93 at 12.3 s came nearest; x = 4.1 at 20 s was the last of 400 messages".
  std::string summary() const;

  /// Puts the plotted field and its values into the verdict.
  void plot(Verdict& verdict) const;

 private:
  struct Look {
    Time time{0};
    std::vector<FieldValue> values;
  };
  std::string wordsOf(const Look& look) const;
  void keep(double value, Time time);

  const Event* event_;
  std::vector<char> isAngle_;
  std::size_t count_ = 0;
  double miss_ = 0;
  double leastMiss_ = 0;
  Look last_;
  Look closest_;
  /// Each `stride_`th value of the first criterion.
  std::vector<double> times_, values_;
  std::size_t stride_ = 1;
};

}  // namespace pongsim::sim
