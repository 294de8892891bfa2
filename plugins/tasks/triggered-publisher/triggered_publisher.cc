#include <google/protobuf/message.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "match.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"
#include "service_call.hh"
#include "typed_name.hh"

namespace pongsim {

namespace {

/// Publishes messages from the world's file whenever a message arrives that meets all conditions.
class TriggeredPublisher : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Publishes messages from the world's file whenever a matching message arrives.",
                   Declaration::Place::kAnywhere);
    declaration.element(
        "input",
        "`type` and `topic` of the input; one only. Each `<match>` in it is a condition, and all must hold: "
        "its text is a message, or with `field` (a path such as pose.position.x) the value of that "
        "field; `tol` (1e-8) for numbers, `logic_type` (positive, negative)");
    declaration.element("output", "`type` and `topic` to publish on, and a message's text; may be repeated");
    declaration.element("service",
                        "a service to call after that: `name`, `reqType`, `repType`, `reqMsg`, `timeout` [ms]; may be "
                        "repeated");
    declaration.parameter("delay_ms", &delayMs_, "ms", "delay in simulated time").atLeast(0);
    declaration.sharesTopics();
  }

  void configure(const SystemContext& context) override {
    const Element& sdf = context.sdf;
    const Element* input = sdf.child("input");
    if (input == nullptr) refuse(sdf, "a TriggeredPublisher needs an <input>");
    source_ = typedName(*input, "topic", "type");
    readMatches(*input, context.diagnostics);
    for (const Element* output : sdf.childrenNamed("output")) addOutput(*output, context);
    for (const Element* service : sdf.childrenNamed("service")) calls_.push_back(serviceCall(*service));
    if (outputs_.empty() && calls_.empty()) refuse(sdf, "a TriggeredPublisher needs an <output> or a <service>");
    services_.emplace(context.node, context.log);
    delay_ = std::chrono::milliseconds(delayMs_);
    checkForLoop(context);
    subscription_ =
        context.node.subscribe(source_.name, source_.type, [this](const Message& message) { receive(message); });
  }

  void preUpdate(const StepInfo& info) override {
    // The delay of a message starts at the time of the last step before it arrived.
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

  void transfer(StateArchive& archive) override {
    archive(due_);
    archive(now_);
  }

 private:
  struct Output {
    TypedName target;
    Publisher publisher;
    MessagePointer message;
  };
  /// A chain of systems, each of which triggers the next.
  struct Chain {
    const TriggeredPublisher* end;
    std::string topics;
    Time delay;
  };

  void readMatches(const Element& input, Diagnostics& diagnostics) {
    const std::vector<const Element*> all = input.childrenNamed("match");
    for (const Element* match : all) {
      if (match->text.empty()) {
        // as in Fortress, which does not report it
        diagnostics.warning(match->position, "a <match> without text is ignored");
      } else {
        matches_.emplace_back(*match, source_.type);
      }
    }
    if (matches_.empty() && !all.empty()) refuse(input, "no <match> is left");
  }

  void addOutput(const Element& element, const SystemContext& context) {
    const TypedName target = typedName(element, "topic", "type");
    Output output{target, context.node.advertise(target.name, target.type), newMessage(target.type)};
    if (const std::optional<MessageError> error = parseMessage(element.text, *output.message)) {
      // as in Fortress, which sends the fields that it could read
      context.diagnostics.warning(element.position,
                                  "the text of this <output> is not of type " + target.type + ": " + error->message +
                                      "; the fields before the error are published",
                                  error->hint);
    }
    outputs_.push_back(std::move(output));
  }

  bool matches(const Message& message) const {
    return std::ranges::all_of(matches_, [&](const Match& match) { return match.matches(message); });
  }

  bool isTriggeredBy(const Output& output) const {
    return output.target.name == source_.name && output.target.type == source_.type && matches(*output.message);
  }

  /// The published messages are known in advance, and so is what they trigger: refuses to close a loop without delay.
  void checkForLoop(const SystemContext& context) const {
    std::vector<const TriggeredPublisher*> others;
    for (const System* system : context.before) {
      if (const auto* other = dynamic_cast<const TriggeredPublisher*>(system)) others.push_back(other);
    }
    std::vector<Chain> chains = {{this, source_.name, delay_}};
    while (!chains.empty()) {
      const Chain chain = std::move(chains.back());
      chains.pop_back();
      for (const Output& output : chain.end->outputs_) {
        const std::string topics = chain.topics + " -> " + output.target.name;
        if (isTriggeredBy(output)) return reportLoop(topics, chain.delay, context);
        std::erase_if(others, [&](const TriggeredPublisher* other) {
          if (!other->isTriggeredBy(output)) return false;
          chains.push_back({other, topics, chain.delay + other->delay_});
          return true;
        });
      }
    }
  }

  static void reportLoop(const std::string& topics, Time delay, const SystemContext& context) {
    if (delay == Time::zero()) {
      refuse(context.sdf, "its own output would trigger it forever: " + topics,
             "add a <match> that its output does not meet, or a <delay_ms>");
    }
    const auto milliseconds = std::chrono::duration_cast<std::chrono::milliseconds>(delay).count();
    context.log.info("triggers itself again after " + std::to_string(milliseconds) + " ms: " + topics);
  }

  void receive(const Message& message) {
    if (!matches(message)) return;
    if (delay_ == Time::zero()) {
      publish();
    } else {
      due_.push_back(now_ + delay_);
    }
  }

  void publish() {
    for (Output& output : outputs_) output.publisher.publish(*output.message);
    for (const BackgroundCalls::Call& call : calls_) services_->post(call);
  }

  int delayMs_ = 0;
  TypedName source_;
  std::vector<Match> matches_;
  std::vector<Output> outputs_;
  std::vector<BackgroundCalls::Call> calls_;
  std::optional<BackgroundCalls> services_;
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
