#include "pongsim/comms_system.hh"

#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/stringmsg_v.pb.h>

#include <chrono>
#include <utility>

#include "pongsim/messages/fields.hh"
#include "pongsim/parameter_group.hh"

namespace pongsim {

namespace {

using ignition::msgs::Dataframe;
using ignition::msgs::StringMsg_V;

constexpr const char* kMessagesTopic = "/broker/msgs";
constexpr const char* kBindService = "/broker/bind";
constexpr const char* kUnbindService = "/broker/unbind";

// limits of what waits for the next step, which does not come while the simulation is paused
constexpr std::size_t kMostWaiting = 1000;
constexpr std::size_t kMostWaitingBytes = 64 << 20;

ServiceAnswer wrongCount(const std::string& wanted, const StringMsg_V& request) {
  return ServiceAnswer::refused(wanted + ", not " + std::to_string(request.data_size()) + " texts");
}

std::string dropped(const Dataframe& message, const std::string& why) {
  return "a message from '" + message.src_address() + "' to '" + message.dst_address() + "' was dropped: " + why;
}

std::string unbound(const std::string& address) { return "no model has bound '" + address + "'"; }

}  // namespace

/// A binding in a saved state.
struct CommsSystem::Saved {
  std::string address;
  std::string modelName;
  /// Whether the model was found.
  bool isAttached = false;
  std::vector<std::string> topics;
  /// The messages in protobuf's binary form.
  std::vector<std::string> outbound;

  void transfer(StateArchive& archive) {
    archive(address);
    archive(modelName);
    archive(isAttached);
    archive(topics);
    archive(outbound);
  }
};

void CommsSystem::declare(Declaration& declaration) {
  declaration.element("broker",
                      "other names: `<messages_topic>` /broker/msgs, `<bind_service>` "
                      "/broker/bind, `<unbind_service>` /broker/unbind");
  declaration
      .parameter("step_size", &stepSize_, "s", "accepted without effect: one round per step delivers all messages")
      .above(0)
      .otherwise("a step");
  declaration.subscribes(kMessagesTopic, "ignition.msgs.Dataframe", "messages between addresses");
  declaration.serves(kBindService, "ignition.msgs.StringMsg_V", "ignition.msgs.Boolean",
                     "binds an address to a topic: address, model, topic");
  declaration.serves(kUnbindService, "ignition.msgs.StringMsg_V", "ignition.msgs.Empty", "unbinds: address, topic");
  declaration.publishes("TOPIC", "ignition.msgs.Dataframe", "messages to an address, on the topic TOPIC bound to it");
}

void CommsSystem::configure(const SystemContext& context) {
  log_ = &context.log;
  world_ = &context.world;
  node_ = &context.node;
  std::string messages = kMessagesTopic, bindName = kBindService, unbindName = kUnbindService;
  Declaration names;
  names.parameter("messages_topic", &messages, "", "");
  names.parameter("bind_service", &bindName, "", "");
  names.parameter("unbind_service", &unbindName, "", "");
  readGroup(context, "broker", names);
  bind_ = context.node.serve<StringMsg_V, ignition::msgs::Boolean>(
      bindName, [this](const StringMsg_V& request, ignition::msgs::Boolean& reply) {
        reply.set_data(true);
        if (request.data_size() != 3) return wrongCount("binding needs an address, a model and a topic", request);
        return bind(request.data(0), request.data(1), request.data(2));
      });
  unbind_ = context.node.serve<StringMsg_V, ignition::msgs::Empty>(
      unbindName, [this](const StringMsg_V& request, ignition::msgs::Empty&) {
        if (request.data_size() != 2) return wrongCount("unbinding needs an address and a topic", request);
        return unbind(request.data(0), request.data(1));
      });
  messages_ = context.node.subscribe<Dataframe>(messages, [this](const Dataframe& message) { receive(message); });
}

void CommsSystem::preUpdate(const StepInfo& info) {
  if (info.paused) return;
  now_ = info.time;
  carryAll();
}

void CommsSystem::reset() {
  bindings_.clear();
  now_ = nextWarning_ = Time::zero();
  unmentioned_ = 0;
  waitingBytes_ = waitingCount_ = 0;
}

void CommsSystem::transfer(StateArchive& archive) {
  std::vector<Saved> saved;
  for (const auto& [address, binding] : bindings_) {
    Saved& each = saved.emplace_back(Saved{address, binding.modelName, binding.model.has_value(), {}, {}});
    for (const auto& [topic, publisher] : binding.topics) each.topics.push_back(topic);
    for (const Dataframe& message : binding.outbound) each.outbound.push_back(message.SerializeAsString());
  }
  archive(saved);
  archive(now_);
  archive(nextWarning_);
  archive(unmentioned_);
  if (archive.isGiving()) restore(saved, archive);
}

void CommsSystem::restore(const std::vector<Saved>& all, StateArchive& archive) {
  bindings_.clear();
  waitingCount_ = waitingBytes_ = 0;
  for (const Saved& saved : all) {
    Binding& binding = bindings_[saved.address];
    binding.modelName = saved.modelName;
    if (saved.isAttached) binding.model = find(saved.modelName);
    for (const std::string& topic : saved.topics) {
      archive.check(!topicNameError(topic));
      binding.topics.try_emplace(topic, node_->advertise<Dataframe>(topic));
    }
    for (const std::string& bytes : saved.outbound) {
      archive.check(waitingCount_ < kMostWaiting && binding.outbound.emplace_back().ParseFromString(bytes));
      ++waitingCount_;
      waitingBytes_ += binding.outbound.back().data().size();
    }
  }
}

void CommsSystem::warnSeldom(const std::string& text) {
  if (now_ < nextWarning_) {
    ++unmentioned_;
    return;
  }
  nextWarning_ = now_ + std::chrono::seconds(1);
  log_->warning(text + (unmentioned_ > 0 ? " (" + std::to_string(unmentioned_) + " more since the last warning)" : ""));
  unmentioned_ = 0;
}

ServiceAnswer CommsSystem::bind(const std::string& address, const std::string& model, const std::string& topic) {
  if (address.empty()) return ServiceAnswer::refused("the address is empty");
  const auto found = bindings_.find(address);
  if (found != bindings_.end() && !found->second.topics.empty() && found->second.modelName != model) {
    return ServiceAnswer::refused("the address '" + address + "' is bound to the model '" + found->second.modelName +
                                  "' already");
  }
  if (const std::optional<std::string> fault = topicNameError(topic)) {
    return ServiceAnswer::refused("the topic '" + topic + "' " + *fault);
  }
  Publisher publisher = node_->advertise<Dataframe>(topic);
  Binding& binding = bindings_[address];
  if (binding.modelName != model) binding.model.reset();
  binding.modelName = model;
  binding.topics.try_emplace(topic, std::move(publisher));
  log_->info("address '" + address + "' is bound to the model '" + model + "' on the topic '" + topic + "'");
  return true;
}

ServiceAnswer CommsSystem::unbind(const std::string& address, const std::string& topic) {
  const auto found = bindings_.find(address);
  if (found == bindings_.end() || found->second.topics.erase(topic) == 0) {
    return ServiceAnswer::refused("the address '" + address + "' is not bound to the topic '" + topic + "'");
  }
  if (found->second.topics.empty()) {
    found->second.model.reset();
    found->second.modelName.clear();
  }
  log_->info("address '" + address + "' is no longer bound to the topic '" + topic + "'");
  return true;
}

void CommsSystem::receive(const Dataframe& message) {
  if (waitingCount_ >= kMostWaiting || waitingBytes_ + message.data().size() > kMostWaitingBytes) {
    warnSeldom("a message from '" + message.src_address() + "' was dropped: too many are waiting for the next step");
    return;
  }
  const auto from = bindings_.find(message.src_address());
  if (from == bindings_.end()) return warnSeldom(dropped(message, unbound(message.src_address())));
  ++waitingCount_;
  waitingBytes_ += message.data().size();
  setStamp(now_, *from->second.outbound.emplace_back(message).mutable_header());
}

/// Delivers all waiting messages, then looks up the models of addresses.
void CommsSystem::carryAll() {
  if (waitingCount_ > 0) {
    for (auto& [address, binding] : bindings_) {
      for (Dataframe& message : binding.outbound) carry(address, binding, message);
      binding.outbound.clear();
    }
    waitingCount_ = waitingBytes_ = 0;
  }
  for (auto& [address, binding] : bindings_) {
    if (binding.model && !binding.model->exists()) binding.model.reset();
    if (!binding.model && !binding.topics.empty()) binding.model = find(binding.modelName);
  }
}

void CommsSystem::carry(const std::string& address, const Binding& from, Dataframe& message) {
  const auto to = bindings_.find(message.dst_address());
  if (to == bindings_.end()) return warnSeldom(dropped(message, unbound(message.dst_address())));
  std::string why = whyDetached(address, from);
  if (why.empty()) why = whyDetached(to->first, to->second);
  if (!why.empty()) return warnSeldom(dropped(message, why));
  if (!carries({address, *from.model}, {to->first, *to->second.model}, now_, message)) return;
  for (auto& [topic, publisher] : to->second.topics) publisher.publish(message);
}

void CommsSystem::deliver(const std::string& address, const Dataframe& message) {
  const auto to = bindings_.find(address);
  if (to == bindings_.end()) return;
  for (auto& [topic, publisher] : to->second.topics) publisher.publish(message);
}

std::optional<Model> CommsSystem::modelOf(const std::string& address) const {
  const auto found = bindings_.find(address);
  if (found == bindings_.end() || !whyDetached(address, found->second).empty()) return std::nullopt;
  return found->second.model;
}

/// @return Why the address has no model, or nothing.
std::string CommsSystem::whyDetached(const std::string& address, const Binding& binding) const {
  if (binding.model && binding.model->exists()) return {};
  if (binding.topics.empty()) return unbound(address);
  if (find(binding.modelName)) return "'" + address + "' was bound in this step";
  return "'" + address + "' is bound to the model '" + binding.modelName + "', which does not exist";
}

/// @return The model with that name: "outer::inner", or the first with that own name.
std::optional<Model> CommsSystem::find(const std::string& name) const {
  if (std::optional<Model> model = world_->model(name)) return model;
  std::vector<Model> models = world_->models();
  for (std::size_t i = 0; i < models.size(); ++i) {
    // a copy, because the list grows
    const Model model = models[i];
    if (model.name() == name) return model;
    for (const Model& inner : model.models()) models.push_back(inner);
  }
  return std::nullopt;
}

}  // namespace pongsim
