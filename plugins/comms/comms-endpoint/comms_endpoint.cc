#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/stringmsg_v.pb.h>

#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "pongsim/parameter_group.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Binds an address to a topic at the broker.
class CommsEndpoint : public System {
 public:
  ~CommsEndpoint() override {
    if (!isBound_ && !pending_) return;
    ignition::msgs::StringMsg_V request;
    request.add_data(address_);
    request.add_data(topic_);
    // no callback: this system is being destroyed
    node_->request(unbindService_, request, "ignition.msgs.Empty", {});
  }

  void declare(Declaration& declaration) override {
    declaration.is("Binds an address to a topic: messages for the address arrive on that topic.",
                   Declaration::Place::kModel);
    declaration.parameter("address", &address_, "", "address for messages").required();
    declaration.parameter("topic", &topic_, "", "topic for messages to the address").required();
    declaration.element("broker",
                        "other names: `<bind_service>` /broker/bind, `<unbind_service>` "
                        "/broker/unbind");
  }

  void configure(const SystemContext& context) override {
    Declaration names;
    names.parameter("bind_service", &bindService_, "", "");
    names.parameter("unbind_service", &unbindService_, "", "");
    readGroup(context, "broker", names);
    if (const std::optional<std::string> fault = topicNameError(topic_)) {
      refuse(*context.sdf.child("topic"), "<topic> '" + topic_ + "' " + *fault);
    }
    node_ = &context.node;
    log_ = &context.log;
    request_.add_data(address_);
    request_.add_data(context.model->scopedName());
    request_.add_data(topic_);
    bind();
    if (!pending_) {
      context.diagnostics.warning(context.sdf.position,
                                  "the address '" + address_ +
                                      "' is not bound: no system before this one offers the service '" + bindService_ +
                                      "'",
                                  "add a broker to the world before it: ignition-gazebo-perfect-comms-system, "
                                  "ignition-gazebo-rf-comms-system or gz-sim-acoustic-comms-system");
    }
  }

  void preUpdate(const StepInfo& info) override {
    now_ = info.time;
    if (isBound_ || pending_ || now_ < nextTry_) return;
    nextTry_ = now_ + kPatience;
    bind();
  }

  void reset() override {
    now_ = nextTry_ = Time::zero();
    isBound_ = hasWarned_ = false;
    bind();
  }

  void transfer(StateArchive& archive) override {
    bool isPending = static_cast<bool>(pending_);
    archive(isBound_);
    archive(nextTry_);
    archive(isPending);
    if (!archive.isGiving()) return;
    pending_ = {};
    // a pending request is not part of a state, so it is sent again
    if (isPending) bind();
  }

 private:
  static constexpr std::chrono::seconds kPatience{1};

  void bind() {
    pending_ = node_->request(bindService_, request_, "ignition.msgs.Boolean",
                              [this](const CallResult& result, const Message&) { note(result); });
  }

  void note(const CallResult& result) {
    isBound_ = static_cast<bool>(result);
    pending_ = {};
    if (isBound_) return;
    nextTry_ = now_ + kPatience;
    // the world is ending
    if (result.outcome == CallOutcome::kGone) return;
    if (!std::exchange(hasWarned_, true)) log_->warning(result.error + "; retrying every second");
  }

  std::string address_;
  std::string topic_;
  std::string bindService_ = "/broker/bind";
  std::string unbindService_ = "/broker/unbind";
  Node* node_ = nullptr;
  const Logger* log_ = nullptr;
  ignition::msgs::StringMsg_V request_;
  bool isBound_ = false;
  bool hasWarned_ = false;
  Time now_{0};
  Time nextTry_{0};
  PendingRequest pending_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::CommsEndpoint, "ignition::gazebo::systems::CommsEndpoint",
                      "gz::sim::systems::CommsEndpoint");
