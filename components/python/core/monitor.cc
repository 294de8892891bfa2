#include "core/monitor.hh"

#include <pybind11/stl.h>

#include <chrono>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/errors.hh"
#include "core/interpreter.hh"
#include "core/owner.hh"
#include "core/topics.hh"

namespace pongsim::python {

namespace {

/// @return The value that a word stands for. Raises ValueError.
template <class Value>
Value valueOf(const std::map<std::string_view, Value>& words, const py::handle& word) {
  const auto text = word.cast<std::string>();
  const auto found = words.find(text);
  if (found == words.end()) throw py::value_error("there is no '" + text + "'");
  return found->second;
}

Time timeOf(const py::handle& seconds) {
  const auto number = seconds.cast<double>();
  if (!std::isfinite(number) || std::abs(number) > 9e9) throw py::value_error("a time must be finite and below 9e9 s");
  return fromSeconds(number);
}

Criterion criterionFrom(const py::dict& given) {
  using Relation = Criterion::Relation;
  static const std::map<std::string_view, Relation> kRelations = {
      {"equals", Relation::kEquals},    {"differs", Relation::kDiffers}, {"above", Relation::kAbove},
      {"at_least", Relation::kAtLeast}, {"below", Relation::kBelow},     {"at_most", Relation::kAtMost},
      {"near", Relation::kNear},        {"between", Relation::kBetween}, {"contains", Relation::kContains},
      {"recorded", Relation::kRecorded}};
  Criterion criterion;
  criterion.field = given["field"].cast<std::string>();
  criterion.relation = valueOf(kRelations, given["relation"]);
  if (given.contains("number")) criterion.number = given["number"].cast<double>();
  if (given.contains("other")) criterion.other = given["other"].cast<double>();
  if (given.contains("text")) criterion.text = given["text"].cast<std::string>();
  if (given.contains("truth")) criterion.isTruth = given["truth"].cast<bool>();
  if (given.contains("recorded")) {
    const auto [times, values] = given["recorded"].cast<std::pair<std::vector<double>, std::vector<double>>>();
    if (times.size() != values.size()) throw py::value_error("a recorded run has as many times as values");
    criterion.recorded = std::make_shared<const RecordedValues>(RecordedValues{times, values});
  }
  return criterion;
}

Event eventFrom(const py::handle& given) {
  using Kind = Signal::Kind;
  static const std::map<std::string_view, Kind> kKinds = {{"topic", Kind::kTopic},
                                                          {"pose", Kind::kPose},
                                                          {"velocity", Kind::kVelocity},
                                                          {"joint", Kind::kJoint},
                                                          {"contact", Kind::kContact}};
  const auto parts = given.cast<py::dict>();
  Event event{{valueOf(kKinds, parts["kind"]), parts["name"].cast<std::string>()}};
  if (parts.contains("other")) event.signal.other = parts["other"].cast<std::string>();
  for (const py::handle& criterion : parts["criteria"]) {
    event.criteria.push_back(criterionFrom(criterion.cast<py::dict>()));
  }
  return event;
}

Expectation expectationFrom(const py::dict& given) {
  using Mode = Expectation::Mode;
  static const std::map<std::string_view, Mode> kModes = {{"eventually", Mode::kEventually},
                                                          {"always", Mode::kAlways},
                                                          {"never", Mode::kNever},
                                                          {"in_order", Mode::kInOrder}};
  Expectation expectation;
  expectation.mode = valueOf(kModes, given["mode"]);
  for (const py::handle& event : given["events"]) expectation.events.push_back(eventFrom(event));
  if (expectation.events.empty()) throw py::value_error("an expectation needs an event");
  if (given.contains("after")) expectation.after = eventFrom(given["after"]);
  if (given.contains("until")) expectation.until = eventFrom(given["until"]);
  if (given.contains("from")) expectation.from = timeOf(given["from"]);
  if (given.contains("to")) expectation.to = timeOf(given["to"]);
  if (given.contains("hold")) expectation.hold = timeOf(given["hold"]);
  return expectation;
}

/// @return The topic; raises ValueError.
LockstepOptions::Topic topicOf(const std::string& text) {
  Outcome<LockstepOptions::Topic> topic = lockstepTopic(text);
  if (!topic) throw py::value_error(topic.error);
  return *std::move(topic.value);
}

LockstepOptions lockstepFrom(const py::handle& given) {
  const auto parts = given.cast<py::dict>();
  LockstepOptions options;
  for (const py::handle& text : parts["topics"]) options.topics.push_back(topicOf(text.cast<std::string>()));
  options.heard = parts["start"].cast<std::vector<std::string>>();
  options.timeout = timeOf(parts["timeout"]);
  options.goesOnWhenLate = parts["late"].cast<std::string>() == "continue";
  return options;
}

/// Calls a function of Python within steps, some times a second.
class Between {
 public:
  Between(Life& life, const py::object& function) : life_(life), function_(function) {}

  void call() {
    const Clock::time_point now = Clock::now();
    if (function_.is_none() || now < next_) return;
    next_ = now + std::chrono::milliseconds(50);
    const interpreter::Held gil;
    try {
      function_();
    } catch (py::error_already_set& error) {
      life_.noteError(error);
    }
  }

 private:
  using Clock = std::chrono::steady_clock;
  Life& life_;
  const py::object& function_;
  Clock::time_point next_ = Clock::now();
};

const char* wordOf(Verdict::State state) {
  if (state == Verdict::State::kPending) return "pending";
  return state == Verdict::State::kMet ? "met" : "failed";
}

/// @return Whether another process publishes the topic, or subscribes to it, within a wall time [s].
bool waitForOther(Owner& owner, const std::string& topic, bool publisher, double timeout) {
  Simulation& simulation = owner.life->edit("waiting");
  bool isThere = false;
  owner.life->stepping([&] {
    const auto limit = std::chrono::nanoseconds(static_cast<std::int64_t>(timeout * 1e9));
    const TopicInfo info = simulation.transport().waitForTopic(topic, publisher, limit);
    isThere = !(publisher ? info.publishers : info.subscribers).empty();
  });
  return isThere;
}

}  // namespace

std::shared_ptr<PyMonitor> PyMonitor::open(const std::shared_ptr<Life>& life, const py::object& lockstep) {
  auto made = std::make_shared<PyMonitor>();
  made->life_ = life;
  Simulation& simulation = life->edit("a monitor");
  if (!lockstep.is_none()) made->lockstep_ = std::make_unique<LockstepRun>(simulation, lockstepFrom(lockstep));
  made->monitor_ = std::make_unique<Monitor>(simulation);
  life->hold(made);
  return made;
}

Monitor& PyMonitor::use() const {
  const auto life = life_.lock();
  if (!monitor_ || !life) raise("Gone", "the simulation of this monitor is gone");
  life->edit("judging");
  return *monitor_;
}

std::size_t PyMonitor::add(const py::dict& expectation) {
  const Outcome<std::size_t> number = use().add(expectationFrom(expectation));
  if (!number) throw py::value_error(number.error);
  return *number.value;
}

bool PyMonitor::runUntil(double seconds, const py::object& between) {
  Monitor& monitor = use();
  const auto life = life_.lock();
  const Time end = timeOf(py::float_(seconds));
  Between inBetween(*life, between);
  const auto goesOn = [&] {
    inBetween.call();
    return !life->mustStop();
  };
  Outcome<bool> made{true, {}};
  const auto step = [&] { made = lockstep_->step(goesOn); };
  bool isDecided = false;
  try {
    life->stepping([&] {
      isDecided = lockstep_ ? monitor.runUntil(
                                  end, [&] { return made && goesOn(); }, step)
                            : monitor.runUntil(end, goesOn);
    });
  } catch (const py::error_already_set&) {
    throw;
  } catch (const Gone&) {
    throw;
  } catch (const std::runtime_error& error) {
    life->raiseFailure(error.what());
  }
  if (!made) throw std::runtime_error(made.error);
  return isDecided;
}

void PyMonitor::finish() {
  Monitor& monitor = use();
  life_.lock()->stepping([&] { monitor.finish(); });
}

py::tuple PyMonitor::verdict(std::size_t number) {
  const Verdict verdict = use().verdict(number);
  return py::make_tuple(wordOf(verdict.state), toSeconds(verdict.time), verdict.expected, verdict.seen, verdict.field,
                        verdict.times, verdict.values);
}

void bindMonitor(py::module_& module) {
  py::class_<PyMonitor, std::shared_ptr<PyMonitor>>(module, "Monitor",
                                                    "Judges what is expected of a simulation, for pongsim.testing.")
      .def(py::init([](const Owner& simulation, const py::object& lockstep) {
             return PyMonitor::open(simulation.life, lockstep);
           }),
           py::arg("simulation"), py::arg("lockstep") = py::none())
      .def("add", &PyMonitor::add)
      .def("run_until", &PyMonitor::runUntil, py::arg("time"), py::arg("between") = py::none())
      .def("finish", &PyMonitor::finish)
      .def_property_readonly("decided", &PyMonitor::decided)
      .def("verdict", &PyMonitor::verdict);
  module.def("wait_for_other", &waitForOther);
  module.def("check_lockstep_topic", [](const std::string& text) { topicOf(text); });
  module.def("topic_name_error", [](const std::string& name) { return topicNameError(name).value_or(""); });
  module.def("unknown_lockstep_topics", [](const Owner& simulation, const py::dict& lockstep) {
    return unknownLockstepTopics(lockstepFrom(lockstep), simulation.life->edit("looking").transport().node());
  });
  module.def("check_message", [](const Owner& simulation, const std::string& topic, py::handle message,
                                 const std::string& type) { checkMessage(*simulation.life, topic, message, type); });
}

}  // namespace pongsim::python
