#pragma once

#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/dataframe.pb.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/stringmsg_v.pb.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/messages/fields.hh"
#include "pongsim/parameter_group.hh"
#include "pongsim/system.hh"

namespace pongsim {

/// Base class of systems that carry messages between robots, like the brokers of Fortress's comms. A derived class
/// decides what happens to a message on its way.
///
/// An address is bound to topics, for a model, by a service. A message on the broker's topic is delivered in the next
/// step to all topics of its destination address, if both addresses are bound to existing models. Models are looked up
/// at the end of each step, so an address takes part from the step after it was bound.
class CommsSystem : public System {
 public:
  /// A derived class adds its parameters and its description.
  void declare(Declaration& declaration) override {
    declaration.element("broker",
                        "other names: `<messages_topic>` /broker/msgs, `<bind_service>` "
                        "/broker/bind, `<unbind_service>` /broker/unbind");
    declaration
        .parameter("step_size", &stepSize_, "s", "accepted without effect: one round per step delivers all messages")
        .above(0)
        .otherwise("a step");
    declaration.subscribes("/broker/msgs", "ignition.msgs.Dataframe", "messages between addresses");
    declaration.serves("/broker/bind", "ignition.msgs.StringMsg_V", "ignition.msgs.Boolean",
                       "binds an address to a topic: address, model, topic");
    declaration.serves("/broker/unbind", "ignition.msgs.StringMsg_V", "ignition.msgs.Empty", "unbinds: address, topic");
    declaration.publishes("TOPIC", "ignition.msgs.Dataframe", "messages to an address, on the topic TOPIC bound to it");
  }

  void configure(const SystemContext& context) override {
    log_ = &context.log;
    world_ = &context.world;
    node_ = &context.node;
    std::string messages = "/broker/msgs", bind = "/broker/bind", unbind = "/broker/unbind";
    Declaration names;
    names.parameter("messages_topic", &messages, "", "");
    names.parameter("bind_service", &bind, "", "");
    names.parameter("unbind_service", &unbind, "", "");
    readGroup(context, "broker", names);
    using ignition::msgs::StringMsg_V;
    bind_ = context.node.serve<StringMsg_V, ignition::msgs::Boolean>(
        bind, [this](const StringMsg_V& request, ignition::msgs::Boolean& reply) {
          reply.set_data(true);
          return this->bind(request);
        });
    unbind_ = context.node.serve<StringMsg_V, ignition::msgs::Empty>(
        unbind, [this](const StringMsg_V& request, ignition::msgs::Empty&) { return this->unbind(request); });
    messages_ = context.node.subscribe<ignition::msgs::Dataframe>(
        messages, [this](const ignition::msgs::Dataframe& message) { receive(message); });
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    now_ = info.time;
    carryAll();
  }

  /// Removes all bindings: endpoints bind themselves again.
  void reset() override {
    ends_.clear();
    now_ = nextWarning_ = Time::zero();
    unmentioned_ = 0;
    waitingBytes_ = waitingCount_ = 0;
  }

  void transfer(StateArchive& archive) override {
    std::vector<Saved> saved;
    for (const auto& [address, end] : ends_) saved.push_back(savedOf(address, end));
    archive(saved);
    archive(now_);
    archive(nextWarning_);
    archive(unmentioned_);
    if (archive.isGiving()) restore(saved);
  }

 protected:
  /// An address in messages, at the time of a step.
  struct Radio {
    const std::string& address;
    const Model& model;
  };

  /// Decides what happens to a message. Called once for each message to a bound address, in the order of the senders'
  /// addresses, then of arrival.
  /// @param message May be changed.
  /// @return Whether it is delivered.
  virtual bool carries(const Radio& from, const Radio& to, Time now, ignition::msgs::Dataframe& message) = 0;

  /// Warns at most once per simulated second.
  void warnSeldom(const std::string& text) {
    if (now_ < nextWarning_) {
      ++unmentioned_;
      return;
    }
    nextWarning_ = now_ + std::chrono::seconds(1);
    log_->warning(text +
                  (unmentioned_ > 0 ? " (" + std::to_string(unmentioned_) + " more since the last warning)" : ""));
    unmentioned_ = 0;
  }

 private:
  using Dataframe = ignition::msgs::Dataframe;

  /// An address: its bindings and its outgoing messages.
  struct End {
    std::string modelName;
    /// Empty until it is looked up, and if it does not exist.
    std::optional<Model> model;
    std::map<std::string, Publisher> topics;
    std::vector<Dataframe> outbound;
  };
  struct Saved {
    std::string address;
    std::string modelName;
    bool isAttached = false;
    std::vector<std::string> topics;
    std::vector<std::string> outbound;

    void transfer(StateArchive& archive) {
      archive(address);
      archive(modelName);
      archive(isAttached);
      archive(topics);
      archive(outbound);
    }
  };

  // Most messages that wait for the next step, which does not come while the simulation is paused.
  static constexpr std::size_t kMostWaiting = 1000;
  static constexpr std::size_t kMostWaitingBytes = 64 << 20;

  ServiceAnswer bind(const ignition::msgs::StringMsg_V& request) {
    if (request.data_size() != 3) return refused("binding needs an address, a model and a topic", request.data_size());
    const std::string& address = request.data(0);
    const std::string& model = request.data(1);
    const std::string& topic = request.data(2);
    if (address.empty()) return ServiceAnswer::refused("the address is empty");
    const auto found = ends_.find(address);
    if (found != ends_.end() && !found->second.topics.empty() && found->second.modelName != model) {
      return ServiceAnswer::refused("the address '" + address + "' is bound to the model '" + found->second.modelName +
                                    "' already");
    }
    if (const std::optional<std::string> fault = topicNameError(topic)) {
      return ServiceAnswer::refused("the topic '" + topic + "' " + *fault);
    }
    Publisher publisher = node_->advertise<Dataframe>(topic);
    End& end = ends_[address];
    if (end.modelName != model) end.model.reset();
    end.modelName = model;
    end.topics.try_emplace(topic, std::move(publisher));
    log_->info("address '" + address + "' is bound to the model '" + model + "' on the topic '" + topic + "'");
    return true;
  }

  ServiceAnswer unbind(const ignition::msgs::StringMsg_V& request) {
    if (request.data_size() != 2) return refused("unbinding needs an address and a topic", request.data_size());
    const auto end = ends_.find(request.data(0));
    if (end == ends_.end() || end->second.topics.erase(request.data(1)) == 0) {
      return ServiceAnswer::refused("the address '" + request.data(0) + "' is not bound to the topic '" +
                                    request.data(1) + "'");
    }
    if (end->second.topics.empty()) {
      end->second.model.reset();
      end->second.modelName.clear();
    }
    log_->info("address '" + request.data(0) + "' is no longer bound to the topic '" + request.data(1) + "'");
    return true;
  }

  static ServiceAnswer refused(const std::string& wanted, int count) {
    return ServiceAnswer::refused(wanted + ", not " + std::to_string(count) + " texts");
  }

  void receive(const Dataframe& message) {
    if (waitingCount_ >= kMostWaiting || waitingBytes_ + message.data().size() > kMostWaitingBytes) {
      warnSeldom("a message from '" + message.src_address() + "' was dropped: too many are waiting for the next step");
      return;
    }
    const auto from = ends_.find(message.src_address());
    if (from == ends_.end()) return warnSeldom(dropped(message, "no model has bound '" + message.src_address() + "'"));
    ++waitingCount_;
    waitingBytes_ += message.data().size();
    Dataframe& kept = from->second.outbound.emplace_back(message);
    setStamp(now_, *kept.mutable_header());
  }

  static std::string dropped(const Dataframe& message, const std::string& why) {
    return "a message from '" + message.src_address() + "' to '" + message.dst_address() + "' was dropped: " + why;
  }

  /// Delivers all waiting messages, then looks up the models of addresses.
  void carryAll() {
    if (waitingCount_ > 0) {
      for (auto& [address, end] : ends_) {
        for (Dataframe& message : end.outbound) carry(address, end, message);
        end.outbound.clear();
      }
      waitingCount_ = waitingBytes_ = 0;
    }
    for (auto& [address, end] : ends_) {
      if (end.model && !end.model->exists()) end.model.reset();
      if (!end.model && !end.topics.empty()) end.model = find(end.modelName);
    }
  }

  void carry(const std::string& address, const End& from, Dataframe& message) {
    const auto to = ends_.find(message.dst_address());
    if (to == ends_.end()) {
      return warnSeldom(dropped(message, "no model has bound '" + message.dst_address() + "'"));
    }
    std::string why = whyDetached(address, from);
    if (why.empty()) why = whyDetached(to->first, to->second);
    if (!why.empty()) return warnSeldom(dropped(message, why));
    if (!carries({address, *from.model}, {to->first, *to->second.model}, now_, message)) return;
    for (auto& [topic, publisher] : to->second.topics) publisher.publish(message);
  }

  /// @return Why the address has no model, or nothing.
  std::string whyDetached(const std::string& address, const End& end) const {
    if (end.model && end.model->exists()) return {};
    if (end.topics.empty()) return "no model has bound '" + address + "'";
    if (find(end.modelName)) return "'" + address + "' was bound in this step";
    return "'" + address + "' is bound to the model '" + end.modelName + "', which does not exist";
  }

  /// @return The model with that name: "outer::inner", or the first with that own name.
  std::optional<Model> find(const std::string& name) const {
    if (std::optional<Model> model = world_->model(name)) return model;
    std::vector<Model> models = world_->models();
    for (std::size_t i = 0; i < models.size(); ++i) {
      // a copy, for the list grows
      const Model model = models[i];
      if (model.name() == name) return model;
      for (const Model& inner : model.models()) models.push_back(inner);
    }
    return std::nullopt;
  }

  static Saved savedOf(const std::string& address, const End& end) {
    Saved saved{address, end.modelName, end.model.has_value(), {}, {}};
    for (const auto& [topic, publisher] : end.topics) saved.topics.push_back(topic);
    for (const Dataframe& message : end.outbound) saved.outbound.push_back(message.SerializeAsString());
    return saved;
  }

  void restore(const std::vector<Saved>& all) {
    ends_.clear();
    waitingCount_ = waitingBytes_ = 0;
    for (const Saved& saved : all) {
      End& end = ends_[saved.address];
      end.modelName = saved.modelName;
      if (saved.isAttached) end.model = find(saved.modelName);
      for (const std::string& topic : saved.topics) end.topics.try_emplace(topic, node_->advertise<Dataframe>(topic));
      for (const std::string& bytes : saved.outbound) {
        end.outbound.emplace_back().ParseFromString(bytes);
        ++waitingCount_;
        waitingBytes_ += end.outbound.back().data().size();
      }
    }
  }

  std::optional<double> stepSize_;
  const Logger* log_ = nullptr;
  World* world_ = nullptr;
  Node* node_ = nullptr;
  std::map<std::string, End> ends_;
  std::size_t waitingCount_ = 0;
  std::size_t waitingBytes_ = 0;
  Time now_{0};
  Time nextWarning_{0};
  std::uint64_t unmentioned_ = 0;
  Service bind_;
  Service unbind_;
  Subscription messages_;
};

}  // namespace pongsim
