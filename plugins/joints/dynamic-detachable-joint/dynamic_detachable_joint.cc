#include <ignition/msgs/attach_detach_request.pb.h>
#include <ignition/msgs/entity.pb.h>
#include <ignition/msgs/result.pb.h>

#include <optional>
#include <string>

#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Attaches links that requests name, as a gripper does, and detaches them.
class DynamicDetachableJoint : public System {
 public:
  using Request = ignition::msgs::AttachDetachRequest;
  using Reply = ignition::msgs::Result;

  void declare(Declaration& declaration) override {
    declaration.is("Attaches a nearby link of any model on request, as a gripper does, until it is to detach it.",
                   Declaration::Place::kModel);
    declaration.parameter("parent_link", &parentName_, "", "link of this model").required();
    declaration
        .parameter("attach_distance", &reach_, "m", "largest distance of the origins of both links when attaching")
        .atLeast(0);
    declaration.parameter("service_name", &serviceName_, "", "service for attaching and detaching")
        .otherwise("/model/M/dynamic_detachable_joint/attach_detach");
    declaration.parameter("output_topic", &stateTopic_, "", "topic of the state")
        .otherwise("/model/M/dynamic_detachable_joint/state");
    declaration.element("suppress_child_warning", "no effect: the answer says that the other model does not exist");
    declaration.serves("<service_name>", "ignition.msgs.AttachDetachRequest", "ignition.msgs.Result",
                       "attaches or detaches `child_link_name` of `child_model_name` (`__model__` for this one); an "
                       "`error_code` other than 0 comes with the reason");
    declaration.publishes("<output_topic>", "ignition.msgs.Entity",
                          "on changes: the attached link, by `id` and `type`; 0 and NONE for none");
  }

  void configure(const SystemContext& context) override {
    model_ = *context.model;
    world_ = &context.world;
    parent_ = requiredLink(context.sdf, "parent_link", *model_);
    const std::string prefix = "/model/" + std::string(model_->name()) + "/dynamic_detachable_joint";
    service_ = context.node.serve<Request, Reply>(topicOr(serviceName_, prefix + "/attach_detach"),
                                                  [this](const Request& request, Reply& reply) {
                                                    const Outcome<void> outcome = handle(request);
                                                    reply.set_error_code(outcome ? 0 : 1);
                                                    reply.set_message(outcome.error);
                                                    return true;
                                                  });
    state_ = context.node.advertise<ignition::msgs::Entity>(topicOr(stateTopic_, prefix + "/state"));
  }

  void worldChanged() override {
    if (!joint_ || joint_->exists()) return;
    joint_.reset();
    tell();
  }

  // a reset removes joints made at run time
  void reset() override { joint_.reset(); }

  // the world saves the joint itself, and restores it before this is called
  void transfer(StateArchive& archive) override {
    JointId held = joint_ ? joint_->id() : JointId();
    archive(held.value);
    if (archive.isGiving()) joint_ = world_->joint(held);
  }

 private:
  Outcome<void> handle(const Request& request) {
    const std::string name = "'" + request.child_model_name() + "::" + request.child_link_name() + "'";
    switch (request.command()) {
      case Request::ATTACH: {
        if (joint_) return Outcome<void>{"link '" + joint_->child().scopedName() + "' is attached already"};
        const std::optional<Model> model =
            request.child_model_name() == "__model__" ? model_ : world_->model(request.child_model_name());
        const std::optional<Link> child = model ? model->link(request.child_link_name()) : std::nullopt;
        if (!child) return Outcome<void>{name + " is no link in the world"};
        return attach(*child);
      }
      case Request::DETACH: {
        if (!joint_) return Outcome<void>{"no link is attached"};
        const Link child = joint_->child();
        const bool isOwn = request.child_model_name() == "__model__" && child.model().id() == model_->id();
        const bool isMeant = child.name() == request.child_link_name() &&
                             (isOwn || child.model().scopedName() == request.child_model_name());
        if (!isMeant) return Outcome<void>{"link '" + child.scopedName() + "' is attached, not " + name};
        return detach();
      }
      default:
        return Outcome<void>{"the command must be ATTACH or DETACH"};
    }
  }

  Outcome<void> attach(const Link& child) {
    const double distance = (child.pose().position - parent_->pose().position).norm();
    if (!(distance <= reach_)) {
      return Outcome<void>{"link '" + child.scopedName() + "' is too far away: " + std::to_string(distance) + " m"};
    }
    const Outcome<Joint> made = world_->attach(*parent_, child);
    if (!made) return Outcome<void>{made.error};
    joint_ = made.value;
    tell();
    return {};
  }

  Outcome<void> detach() {
    const Outcome<void> removed = world_->detach(*joint_);
    if (!removed) return removed;
    joint_.reset();
    tell();
    return {};
  }

  void tell() {
    ignition::msgs::Entity message;
    if (joint_) {
      message.set_id(joint_->child().id().value);
      message.set_type(ignition::msgs::Entity::LINK);
    }
    state_.publish(message);
  }

  std::string parentName_, serviceName_, stateTopic_;
  double reach_ = 0.1;

  World* world_ = nullptr;
  std::optional<Model> model_;
  std::optional<Link> parent_;
  std::optional<Joint> joint_;
  Service service_;
  Publisher state_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::DynamicDetachableJoint, "gz::sim::systems::DynamicDetachableJoint",
                      "ignition::gazebo::systems::DynamicDetachableJoint");
