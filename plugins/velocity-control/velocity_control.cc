#include <ignition/msgs/twist.pb.h>

#include <list>
#include <optional>
#include <string>

#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Gives a model, and links of it, the velocity that it is told, in every step.
class VelocityControl : public System {
 public:
  void configure(const SystemContext& context) override {
    const Element& sdf = context.sdf;
    model_ = requiredModel(context, "VelocityControl");
    if (model_->parent()) refuse(sdf, "VelocityControl moves models at the top level only");
    log_ = &context.log;
    initial_ = command_ = {sdf.get("initial_linear", Vector3(0, 0, 0)), sdf.get("initial_angular", Vector3(0, 0, 0))};
    if (!isFinite(initial_)) refuse(sdf, "the initial velocity must be finite");
    const std::string prefix = "/model/" + std::string(model_->name());
    subscription_ = context.node.subscribe<ignition::msgs::Twist>(topicParameter(sdf, "topic", prefix + "/cmd_vel"),
                                                                  [this](const auto& twist) { read(twist, command_); });
    for (const Element* element : sdf.childrenNamed("link_name")) {
      const std::optional<Link> link = model_->link(element->text);
      if (!link) {
        refuse(*element,
               "<link_name> '" + element->text + "' is no link of model '" + std::string(model_->name()) + "'");
      }
      LinkCommand& command = links_.emplace_back(LinkCommand{*link, std::nullopt, {}});
      command.subscription = context.node.subscribe<ignition::msgs::Twist>(
          cleanTopic(prefix + "/link/" + element->text + "/cmd_vel"), [this, &command](const auto& twist) {
            Twist read{};
            if (this->read(twist, read)) command.twist = read;
          });
    }
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    const Quaternion q_WorldModel = model_->pose().rotation;
    model_->setVelocity(q_WorldModel * command_.linear, q_WorldModel * command_.angular);
    for (LinkCommand& command : links_) {
      if (!command.twist) continue;
      const Quaternion q_WorldLink = command.link.pose().rotation;
      command.link.setVelocity(q_WorldLink * command.twist->linear, q_WorldLink * command.twist->angular);
    }
  }

  void reset() override {
    command_ = initial_;
    for (LinkCommand& command : links_) command.twist.reset();
  }

 private:
  struct Twist {
    Vector3 linear;
    Vector3 angular;
  };
  struct LinkCommand {
    Link link;
    /// None has come yet.
    std::optional<Twist> twist;
    Subscription subscription;
  };

  static bool isFinite(const Twist& twist) { return twist.linear.allFinite() && twist.angular.allFinite(); }

  /// @return Whether it was finite; else `twist` is as it was.
  bool read(const ignition::msgs::Twist& message, Twist& twist) {
    const Twist found{{message.linear().x(), message.linear().y(), message.linear().z()},
                      {message.angular().x(), message.angular().y(), message.angular().z()}};
    if (!isFinite(found)) {
      log_->warning("a command that is not finite was ignored");
      return false;
    }
    twist = found;
    return true;
  }

  std::optional<Model> model_;
  Twist initial_;
  Twist command_;
  // the subscriptions point into it
  std::list<LinkCommand> links_;
  const Logger* log_ = nullptr;
  Subscription subscription_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::VelocityControl, "ignition::gazebo::systems::VelocityControl",
                      "gz::sim::systems::VelocityControl");
