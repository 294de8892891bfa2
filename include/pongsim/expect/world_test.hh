#pragma once

#include <gtest/gtest.h>

#include <deque>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <source_location>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/expect/expectation.hh"
#include "pongsim/expect/monitor.hh"
#include "pongsim/simulation.hh"

namespace pongsim {

/// A field of a signal, of which comparisons make criteria: `WorldTest::field("data") == true`.
class ExpectedField {
 public:
  explicit ExpectedField(std::string name) : name_(std::move(name)) {}

  Criterion operator==(double value) const { return made(Criterion::Relation::kEquals, value); }
  Criterion operator!=(double value) const { return made(Criterion::Relation::kDiffers, value); }
  Criterion operator>(double value) const { return made(Criterion::Relation::kAbove, value); }
  Criterion operator>=(double value) const { return made(Criterion::Relation::kAtLeast, value); }
  Criterion operator<(double value) const { return made(Criterion::Relation::kBelow, value); }
  Criterion operator<=(double value) const { return made(Criterion::Relation::kAtMost, value); }
  Criterion operator==(int value) const { return *this == static_cast<double>(value); }
  Criterion operator!=(int value) const { return *this != static_cast<double>(value); }
  Criterion operator==(bool value) const {
    return {.field = name_, .number = value ? 1.0 : 0.0, .text = {}, .isTruth = true, .recorded = {}};
  }
  Criterion operator==(const char* text) const { return made(Criterion::Relation::kEquals, text); }
  Criterion operator!=(const char* text) const { return made(Criterion::Relation::kDiffers, text); }
  Criterion contains(const char* text) const { return made(Criterion::Relation::kContains, text); }
  Criterion near(double value, double tolerance) const { return made(Criterion::Relation::kNear, value, tolerance); }
  Criterion between(double low, double high) const { return made(Criterion::Relation::kBetween, low, high); }

 private:
  Criterion made(Criterion::Relation relation, double number, double other = 0) const {
    return {.field = name_, .relation = relation, .number = number, .other = other, .text = {}, .recorded = {}};
  }
  Criterion made(Criterion::Relation relation, const char* text) const {
    return {.field = name_, .relation = relation, .text = text, .recorded = {}};
  }

  std::string name_;
};

/// An expectation in the making; all times in simulated seconds.
class Expecting {
 public:
  Expecting(Signal signal, std::source_location place) : place_(place) { made_.events = {{std::move(signal), {}}}; }

  template <class... Criteria>
  Expecting& eventually(Criteria... criteria) {
    return is(Expectation::Mode::kEventually, {std::move(criteria)...});
  }
  template <class... Criteria>
  Expecting& always(Criteria... criteria) {
    return is(Expectation::Mode::kAlways, {std::move(criteria)...});
  }
  template <class... Criteria>
  Expecting& never(Criteria... criteria) {
    return is(Expectation::Mode::kNever, {std::move(criteria)...});
  }
  /// The first event of several in order.
  template <class... Criteria>
  Expecting& first(Criteria... criteria) {
    return is(Expectation::Mode::kInOrder, {std::move(criteria)...});
  }
  template <class... Criteria>
  Expecting& then(Signal signal, Criteria... criteria) {
    made_.events.push_back({std::move(signal), {std::move(criteria)...}});
    return *this;
  }
  template <class... Criteria>
  Expecting& after(Signal signal, Criteria... criteria) {
    made_.after = Event{std::move(signal), {std::move(criteria)...}};
    return *this;
  }
  template <class... Criteria>
  Expecting& until(Signal signal, Criteria... criteria) {
    made_.until = Event{std::move(signal), {std::move(criteria)...}};
    return *this;
  }
  Expecting& within(double seconds) {
    made_.to = fromSeconds(seconds);
    return *this;
  }
  Expecting& during(double from, double to) {
    made_.from = fromSeconds(from);
    return within(to);
  }
  Expecting& at(double seconds) { return during(seconds, seconds); }
  /// For `eventually`: it must stay so.
  Expecting& lasting(double seconds) {
    made_.hold = fromSeconds(seconds);
    return *this;
  }

  const Expectation& made() const { return made_; }
  const std::source_location& place() const { return place_; }

 private:
  Expecting& is(Expectation::Mode mode, std::vector<Criterion> criteria) {
    made_.mode = mode;
    made_.events.front().criteria = std::move(criteria);
    return *this;
  }

  Expectation made_;
  std::source_location place_;
};

/// A fixture for tests of robots with GoogleTest, with the expectations of `pongsim test` (docs/testing.md):
///
///     using Wall = pongsim::WorldTest;
///     TEST_F(Wall, IsTouched) {
///       load("sensor_tutorial.sdf");
///       publish("/cmd_vel", "Twist", "linear: {x: 2}");
///       expect(topic("/wall/touched")).eventually(field("data") == true).within(20);
///       expect(pose("vehicle_blue")).never(field("z") > 1);
///       run(30);
///     }
class WorldTest : public ::testing::Test {
 protected:
  static Signal topic(std::string name) { return {Signal::Kind::kTopic, std::move(name)}; }
  static Signal pose(std::string name) { return {Signal::Kind::kPose, std::move(name)}; }
  static Signal velocity(std::string name) { return {Signal::Kind::kVelocity, std::move(name)}; }
  static Signal joint(std::string name) { return {Signal::Kind::kJoint, std::move(name)}; }
  static Signal contact(std::string one, std::string other = {}) {
    return {Signal::Kind::kContact, std::move(one), std::move(other)};
  }
  static ExpectedField field(std::string name) { return ExpectedField(std::move(name)); }

  /// Loads a world. Errors and warnings about it fail the test.
  void load(const std::filesystem::path& file, const SimulationOptions& options = {}) {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromFile(file, options, diagnostics);
    begin(diagnostics);
  }
  void loadText(const std::string& text, const SimulationOptions& options = {}) {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(text, "world.sdf", options, diagnostics);
    begin(diagnostics);
  }

  Simulation& simulation() { return *simulation_; }

  /// Publishes a message in protobuf's text format, which arrives at the start of the next step of `run`.
  void publish(const std::string& name, const std::string& type, const std::string& text) {
    publishers_.push_back(simulation_->transport().node().advertise(name, messageTypeName(type).value_or(type)));
    MessagePointer message = newMessage(type);
    const std::optional<MessageError> error = parseMessage(text, *message);
    if (error) ADD_FAILURE() << "the message on " << name << ": " << error->message;
    messages_.emplace_back(publishers_.size() - 1, std::move(message));
  }

  /// Begins an expectation; `run` judges it.
  Expecting& expect(Signal signal, std::source_location place = std::source_location::current()) {
    return expected_.emplace_back(std::move(signal), place);
  }

  /// Steps until all expectations are decided, or for so many simulated seconds; without expectations, for all of them.
  /// Each that is not met fails the test, at its own line.
  void run(double seconds) {
    std::vector<std::pair<std::size_t, std::source_location>> numbers;
    for (const Expecting& each : std::exchange(expected_, {})) {
      const Outcome<std::size_t> added = monitor_->add(each.made());
      if (added) {
        numbers.emplace_back(*added.value, each.place());
      } else {
        ADD_FAILURE_AT(each.place().file_name(), static_cast<int>(each.place().line())) << added.error;
      }
    }
    // now, so that what is expected sees them
    for (const auto& [publisher, message] : messages_) publishers_[publisher].publish(*message);
    messages_.clear();
    const Time end = simulation_->time() + fromSeconds(seconds);
    const std::size_t all = monitor_->decided() + numbers.size();
    while ((numbers.empty() || monitor_->decided() < all) && simulation_->time() < end) monitor_->runUntil(end);
    monitor_->finish();
    for (const auto& [number, place] : numbers) {
      const Verdict verdict = monitor_->verdict(number);
      if (verdict.state == Verdict::State::kMet) continue;
      ADD_FAILURE_AT(place.file_name(), static_cast<int>(place.line()))
          << "expected: " << verdict.expected << "\nseen:     " << verdict.seen << "\nfailed at "
          << toSeconds(verdict.time) << " s";
    }
  }

 private:
  void begin(const Diagnostics& diagnostics) {
    for (const Diagnostic& each : diagnostics.all()) ADD_FAILURE() << format(each);
    if (!simulation_) throw std::runtime_error("the world can't be loaded");
    monitor_ = std::make_unique<Monitor>(*simulation_);
  }

  // in this order: what uses the simulation ends before it
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<Monitor> monitor_;
  std::deque<Publisher> publishers_;
  std::vector<std::pair<std::size_t, MessagePointer>> messages_;
  std::deque<Expecting> expected_;
};

}  // namespace pongsim
