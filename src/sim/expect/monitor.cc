#include "pongsim/expect/monitor.hh"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/nearest_word.hh"
#include "msgs/encoding/bytes.hh"
#include "sim/expect/item.hh"
#include "sim/expect/state_signal.hh"
#include "sim/expect/topic_field.hh"

namespace pongsim {

namespace {

using sim::Evaluation;
using sim::Item;
using sim::StateSignal;
using sim::TopicField;
using sim::Watch;

std::string absolute(const std::string& topic) { return topic.starts_with('/') ? topic : "/" + topic; }

/// A contact without criteria is one that is there.
void complete(Event& event) {
  if (event.signal.kind != Signal::Kind::kContact || !event.criteria.empty()) return;
  event.criteria.push_back({.field = "touching", .number = 1, .isTruth = true});
}

Expectation completed(Expectation expectation) {
  for (Event& event : expectation.events) complete(event);
  if (expectation.after) complete(*expectation.after);
  if (expectation.until) complete(*expectation.until);
  return expectation;
}

}  // namespace

struct Monitor::Parts {
  struct Topic {
    std::vector<Watch*> watches;
    MessagePointer message;
    std::string type;
    /// Whether it had a publisher when it was first watched, which may have gone since.
    bool wasThere = false;
    Subscription subscription;
  };

  explicit Parts(Simulation& watched) : simulation(&watched) {}

  Outcome<void> addWatch(Item& item, const Event& event, Evaluation::Role role, std::size_t number);
  Outcome<void> checkFields(const Event& event) const;
  void listen(const std::string& topic, Watch& watch);
  void hear(Topic& topic, std::string_view type, std::span<const std::byte> bytes);
  void take(Watch& watch, const Message& message, const std::string& type);
  void judge(Watch& watch);
  std::string nobody(const std::string& topic) const;
  std::string reasonOf(const Item& item) const;

  Simulation* simulation;
  std::deque<Item> items;
  std::map<std::string, Topic> topics;
  /// What has a value after each step.
  std::vector<Watch*> states;
  bool hasContacts = false;
  /// How many of the items have been looked at.
  std::size_t lookedAt = 0;
  sim::ContactPoints contacts;
};

Monitor::Monitor(Simulation& simulation) : simulation_(&simulation), parts_(std::make_unique<Parts>(simulation)) {}

Monitor::~Monitor() = default;

Outcome<std::size_t> Monitor::add(Expectation expectation) {
  Item& item = parts_->items.emplace_back(completed(std::move(expectation)));
  Outcome<void> done;
  const auto add = [&](const Event& event, Evaluation::Role role, std::size_t number) {
    if (done) done = parts_->addWatch(item, event, role, number);
  };
  // at the same time, the window is over before a violation counts, and begins before an event counts
  if (item.expectation.until) add(*item.expectation.until, Evaluation::Role::kUntil, 0);
  if (item.expectation.after) add(*item.expectation.after, Evaluation::Role::kAfter, 0);
  for (std::size_t i = 0; i < item.expectation.events.size(); ++i) {
    add(item.expectation.events[i], Evaluation::Role::kEvent, i);
  }
  if (done) return {parts_->items.size() - 1, ""};
  // nothing listens to it any more
  const auto isOfIt = [&](const Watch* watch) { return watch->item == &item; };
  for (auto& [name, topic] : parts_->topics) std::erase_if(topic.watches, isOfIt);
  std::erase_if(parts_->states, isOfIt);
  parts_->items.pop_back();
  return {{}, done.error};
}

Outcome<void> Monitor::Parts::addWatch(Item& item, const Event& event, Evaluation::Role role, std::size_t number) {
  Watch& watch = item.watches.emplace_back(item, event, role, number);
  if (event.signal.kind == Signal::Kind::kTopic) {
    if (const std::optional<std::string> wrong = topicNameError(event.signal.name)) {
      return {"the topic '" + event.signal.name + "' " + *wrong};
    }
    const Outcome<void> fits = checkFields(event);
    if (fits) listen(absolute(event.signal.name), watch);
    return fits;
  }
  Outcome<StateSignal> state = sim::stateSignal(simulation->world(), event, contacts);
  if (!state) return {state.error};
  watch.state = std::move(*state);
  for (std::size_t i = 0; i < watch.state.isAngle.size(); ++i) {
    if (watch.state.isAngle[i]) watch.record.setAngle(i);
  }
  hasContacts = hasContacts || event.signal.kind == Signal::Kind::kContact;
  states.push_back(&watch);
  return {};
}

/// Where the topic's type is known already, mistakes are told before the first message.
Outcome<void> Monitor::Parts::checkFields(const Event& event) const {
  for (const OwnTopic& topic : simulation->transport().node().ownTopics()) {
    if (topic.name != absolute(event.signal.name) || topic.publishers == 0) continue;
    for (const Criterion& criterion : event.criteria) {
      const Outcome<TopicField> field = TopicField::of(criterion, topic.type);
      if (!field) return {field.error};
    }
  }
  return {};
}

void Monitor::Parts::listen(const std::string& name, Watch& watch) {
  Topic& topic = topics[name];
  topic.watches.push_back(&watch);
  if (topic.subscription) return;
  topic.wasThere = nobody(name).empty();
  topic.subscription = simulation->transport().node().subscribeAnyType(
      name, [this, &topic](std::string_view type, std::span<const std::byte> bytes) { hear(topic, type, bytes); },
      {.queueLength = 100'000});
}

void Monitor::Parts::hear(Topic& topic, std::string_view type, std::span<const std::byte> bytes) {
  if (topic.type != type) {
    topic.message = newMessage(type);
    topic.type = type;
  }
  if (!topic.message || !msgs::parseBytes(bytes, *topic.message)) return;
  for (Watch* watch : topic.watches) {
    if (!watch->item->isDecided()) take(*watch, *topic.message, topic.type);
  }
}

void Monitor::Parts::take(Watch& watch, const Message& message, const std::string& type) {
  if (watch.type != type) {
    watch.fields.clear();
    for (const Criterion& criterion : watch.event->criteria) {
      Outcome<TopicField> field = TopicField::of(criterion, type);
      if (!field) {
        watch.item->mistake = watch.event->signal.name + ": " + field.error;
        watch.item->mistakenAt = simulation->time();
        return;
      }
      watch.fields.push_back(*std::move(field));
    }
    watch.type = type;
  }
  for (std::size_t i = 0; i < watch.fields.size(); ++i) watch.values[i] = watch.fields[i].in(message);
  judge(watch);
}

void Monitor::Parts::judge(Watch& watch) {
  const Time now = simulation->time();
  const bool holds = watch.record.holdsFor(watch.values, now);
  if (watch.item->evaluation.see(watch.role, watch.number, now, holds)) watch.record.count(watch.values, now);
}

/// Looks at what was added since the last look, whose first value is that of now.
void Monitor::begin() {
  if (parts_->lookedAt != parts_->items.size()) look();
}

void Monitor::look() {
  parts_->lookedAt = parts_->items.size();
  if (parts_->hasContacts) simulation_->world().contacts(parts_->contacts);
  for (Watch* watch : parts_->states) {
    if (watch->item->isDecided()) continue;
    if (watch->state.read(watch->values)) parts_->judge(*watch);
  }
  // messages that were published in this step arrive at the start of the next one
  for (Item& item : parts_->items) item.evaluation.advance(simulation_->time());
}

void Monitor::finish() {
  simulation_->transport().dispatch();
  for (Item& item : parts_->items) {
    if (item.isDecided()) continue;
    item.evaluation.end(simulation_->time());
    for (const Watch& watch : item.watches) {
      if (watch.event->signal.kind != Signal::Kind::kTopic || watch.record.size() > 0) continue;
      if (item.evaluation.state() != Verdict::State::kMet) continue;
      // nothing was seen, which says nothing
      const std::string nobody = parts_->nobody(watch.event->signal.name);
      if (nobody.empty()) continue;
      item.mistake = nobody;
      item.mistakenAt = simulation_->time();
    }
  }
}

std::size_t Monitor::decided() const {
  return static_cast<std::size_t>(
      std::count_if(parts_->items.begin(), parts_->items.end(), [](const Item& item) { return item.isDecided(); }));
}

/// @return "nobody publishes /a (did you mean '/b'?)"; nothing if somebody does.
std::string Monitor::Parts::nobody(const std::string& topic) const {
  const auto watched = topics.find(absolute(topic));
  if (watched != topics.end() && watched->second.wasThere) return {};
  std::vector<std::string> known;
  for (const OwnTopic& each : simulation->transport().node().ownTopics()) {
    if (each.publishers + each.relayingPublishers > 0) known.push_back(each.name);
  }
  for (const TopicInfo& each : simulation->transport().discover(Time(0))) {
    if (!each.publishers.empty()) known.push_back(each.name);
  }
  if (std::find(known.begin(), known.end(), absolute(topic)) != known.end()) return {};
  const std::vector<std::string_view> words(known.begin(), known.end());
  const std::string hint = base::didYouMean(absolute(topic), words);
  return "nobody publishes " + topic + (hint.empty() ? "" : " (" + hint + ")");
}

std::string Monitor::Parts::reasonOf(const Item& item) const {
  const auto watched = [&](Evaluation::Role role, std::size_t number) -> const Watch& {
    return *std::find_if(item.watches.begin(), item.watches.end(),
                         [&](const Watch& each) { return each.role == role && each.number == number; });
  };
  const auto summary = [&](const Watch& watch) {
    if (watch.event->signal.kind != Signal::Kind::kTopic || watch.record.size() > 0) return watch.record.summary();
    const std::string none = nobody(watch.event->signal.name);
    return none.empty() ? watch.record.summary() : none;
  };
  const Evaluation& evaluation = item.evaluation;
  switch (evaluation.reason()) {
    case Evaluation::Reason::kNoStart:
      return "it did not begin: " + summary(watched(Evaluation::Role::kAfter, 0));
    case Evaluation::Reason::kNoEnd:
      return describe(*item.expectation.until) + " did not come: " + summary(watched(Evaluation::Role::kUntil, 0));
    case Evaluation::Reason::kViolated:
      return watched(Evaluation::Role::kEvent, 0).record.last();
    default:
      break;
  }
  if (item.expectation.mode != Expectation::Mode::kInOrder) return summary(watched(Evaluation::Role::kEvent, 0));
  const std::size_t next = evaluation.reached().size();
  std::string words;
  for (std::size_t i = 0; i < next; ++i) {
    words += std::to_string(i + 1) + " came at " + sim::secondsText(evaluation.reached()[i]) + ", ";
  }
  words += std::to_string(next + 1) + " (" + describe(item.expectation.events[next]) + ") did not";
  if (const auto early = evaluation.cameFirst(next))
    return words + ", only before that, at " + sim::secondsText(*early);
  return words + ": " + summary(watched(Evaluation::Role::kEvent, next));
}

Verdict Monitor::verdict(std::size_t number) const {
  const Item& item = parts_->items.at(number);
  Verdict verdict;
  verdict.expected = describe(item.expectation);
  verdict.state = item.mistake.empty() ? item.evaluation.state() : Verdict::State::kFailed;
  verdict.time = item.mistake.empty() ? item.evaluation.decidedAt() : item.mistakenAt;
  const Watch& first = *std::find_if(item.watches.begin(), item.watches.end(),
                                     [](const Watch& each) { return each.role == Evaluation::Role::kEvent; });
  if (!item.mistake.empty()) {
    verdict.seen = item.mistake;
  } else if (verdict.state == Verdict::State::kFailed) {
    verdict.seen = parts_->reasonOf(item);
  } else {
    verdict.seen = first.record.last();
  }
  first.record.plot(verdict);
  return verdict;
}

}  // namespace pongsim
