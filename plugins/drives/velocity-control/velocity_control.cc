#include <ignition/msgs/twist.pb.h>

#include <list>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/commands.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Sets the velocity of a model and its links to the commanded one in every step.
class VelocityControl : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Sets the velocity of a model and its links to the commanded one in every step.",
                   Declaration::Place::kModel);
    declaration.parameter("topic", &topic_, "", "command topic").otherwise("/model/M/cmd_vel");
    declaration.parameter("initial_linear", &initial_.linear, "m/s", "velocity until the first command, model frame");
    declaration.parameter("initial_angular", &initial_.angular, "rad/s",
                          "angular velocity until the first command, model frame");
    declaration.parameter("link_name", &linkNames_, "", "links with their own command topics");
    declaration.subscribes("<topic>", "ignition.msgs.Twist", "velocity of the model in its own frame [m/s, rad/s]");
    declaration.subscribes("/model/M/link/L/cmd_vel", "ignition.msgs.Twist", "velocity of a link in its own frame");
  }

  void configure(const SystemContext& context) override {
    const Element& sdf = context.sdf;
    model_ = *context.model;
    if (model_->parent()) refuse(sdf, "VelocityControl only moves top-level models");
    command_ = initial_;
    const std::string prefix = "/model/" + std::string(model_->name());
    subscription_ = context.node.subscribe<ignition::msgs::Twist>(
        topicOr(topic_, prefix + "/cmd_vel"), [this](const auto& twist) { command_ = read(twist); }, kCommands);
    for (const Element* element : sdf.childrenNamed("link_name")) {
      const std::optional<Link> link = model_->link(element->text);
      if (!link) {
        refuse(*element,
               "<link_name> '" + element->text + "' is not a link of model '" + std::string(model_->name()) + "'");
      }
      LinkCommand& command = links_.emplace_back(LinkCommand{*link, std::nullopt, {}});
      command.subscription = context.node.subscribe<ignition::msgs::Twist>(
          cleanTopic(prefix + "/link/" + element->text + "/cmd_vel"),
          [&command](const auto& twist) { command.twist = read(twist); }, kCommands);
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

  void transfer(StateArchive& archive) override {
    archive(command_);
    for (LinkCommand& command : links_) archive(command.twist);
  }

 private:
  struct Twist {
    Vector3 linear = Vector3::Zero();
    Vector3 angular = Vector3::Zero();

    void transfer(StateArchive& archive) {
      archive(linear);
      archive(angular);
    }
  };
  struct LinkCommand {
    Link link;
    /// No command has arrived yet.
    std::optional<Twist> twist;
    Subscription subscription;
  };

  static Twist read(const ignition::msgs::Twist& message) {
    return {{message.linear().x(), message.linear().y(), message.linear().z()},
            {message.angular().x(), message.angular().y(), message.angular().z()}};
  }

  std::string topic_;
  std::vector<std::string> linkNames_;
  std::optional<Model> model_;
  Twist initial_;
  Twist command_;
  // the subscriptions keep pointers to it
  std::list<LinkCommand> links_;
  Subscription subscription_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::VelocityControl, "ignition::gazebo::systems::VelocityControl",
                      "gz::sim::systems::VelocityControl");
