#include <google/protobuf/message.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "match.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

[[noreturn]] void fail(const Element& where, std::string message, std::string hint = {}) {
  throw Error({Severity::kError, where.position, std::move(message), std::move(hint)});
}

/// Reads the `type` and `topic` of an `<input>` or `<output>`.
struct TypedTopic {
  explicit TypedTopic(const Element& element) : topic(required(element, "topic")) {
    const std::string asked = required(element, "type");
    const std::optional<std::string> found = messageTypeName(asked);
    if (!found) {
      const std::string nearest = nearestMessageType(asked);
      fail(element, "'" + asked + "' is no message type", nearest.empty() ? "" : "did you mean '" + nearest + "'?");
    }
    type = *found;
    topic = cleanTopic(topic);
    if (const std::optional<std::string> error = topicNameError(topic)) {
      fail(element, "'" + topic + "' is no topic: " + *error);
    }
  }

  static std::string required(const Element& element, std::string_view attribute) {
    const Element::Attribute* found = element.attribute(attribute);
    if (found == nullptr || found->value.empty()) {
      fail(element, "<" + element.name + "> has no '" + std::string(attribute) + "' attribute");
    }
    return found->value;
  }

  std::string topic;
  std::string type;
};

/// Publishes messages given in the world's file whenever a message comes in that matches all of its conditions.
class TriggeredPublisher : public System {
 public:
  void configure(const SystemContext& context) override {
    const Element& sdf = context.sdf;
    const Element* input = sdf.child("input");
    if (input == nullptr) fail(sdf, "a TriggeredPublisher needs an <input>");
    const TypedTopic source(*input);
    for (const Element* match : input->childrenNamed("match")) {
      if (match->text.empty()) fail(*match, "a <match> without text matches nothing");
      matches_.emplace_back(*match, source.type);
    }

    for (const Element* output : sdf.childrenNamed("output")) addOutput(*output, context.node);
    if (outputs_.empty()) fail(sdf, "a TriggeredPublisher needs an <output>");
    if (const Element* service = sdf.child("service")) {
      context.log.warning("line " + std::to_string(service->position.line) +
                          ": <service> is not there yet: no service will be called");
    }

    const int delayMs = sdf.get("delay_ms", 0);
    if (delayMs < 0) fail(*sdf.child("delay_ms"), "<delay_ms> must not be negative");
    delay_ = std::chrono::milliseconds(delayMs);
    subscription_ =
        context.node.subscribe(source.topic, source.type, [this](const Message& message) { receive(message); });
  }

  void preUpdate(const StepInfo& info) override {
    // The time since the last step, as what has come in since began its wait then.
    now_ = info.time;
    while (!due_.empty() && due_.front() <= now_) {
      due_.pop_front();
      publish();
    }
  }

  void reset() override {
    due_.clear();
    now_ = Time::zero();
  }

 private:
  struct Output {
    Publisher publisher;
    MessagePointer message;
  };

  void addOutput(const Element& element, Node& node) {
    const TypedTopic target(element);
    Output output{node.advertise(target.topic, target.type), newMessage(target.type)};
    if (const std::optional<MessageError> error = parseMessage(element.text, *output.message)) {
      fail(element, "the text of this <output> is no " + target.type + ": " + error->message, error->hint);
    }
    outputs_.push_back(std::move(output));
  }

  void receive(const Message& message) {
    if (!std::ranges::all_of(matches_, [&](const Match& match) { return match.matches(message); })) return;
    if (delay_ == Time::zero()) {
      publish();
    } else {
      due_.push_back(now_ + delay_);
    }
  }

  void publish() {
    for (Output& output : outputs_) output.publisher.publish(*output.message);
  }

  std::vector<Match> matches_;
  std::vector<Output> outputs_;
  Time delay_{0};
  Time now_{0};
  /// When to publish, soonest first.
  std::deque<Time> due_;
  Subscription subscription_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::TriggeredPublisher, "ignition::gazebo::systems::TriggeredPublisher",
                      "gz::sim::systems::TriggeredPublisher");
