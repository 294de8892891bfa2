#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <optional>
#include <string>

#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Attaches a link of another model until it is commanded to detach it.
class DetachableJoint : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Attaches a link of another model until it is commanded to detach it.", Declaration::Place::kModel);
    declaration.parameter("parent_link", &parentName_, "", "link of this model").required();
    declaration.parameter("child_model", &childModel_, "", "other model, `__model__` for this one").required();
    declaration.parameter("child_link", &childLink_, "", "link of the other model").required();
    declaration.parameter("detach_topic", &detachTopic_, "", "topic for detaching")
        .otherwise("/model/M/detachable_joint/detach");
    declaration.parameter("topic", &oldTopic_, "", "the same as `<detach_topic>`").otherwise("<detach_topic>");
    declaration.parameter("attach_topic", &attachTopic_, "", "topic for attaching")
        .otherwise("/model/M/detachable_joint/attach");
    declaration.parameter("output_topic", &stateTopic_, "", "topic of the state")
        .otherwise("/model/CHILD/detachable_joint/state");
    declaration.parameter("suppress_child_warning", &isQuiet_, "", "no warning while the other model does not exist");
    declaration.subscribes("<detach_topic>", "ignition.msgs.Empty", "detaches the child");
    declaration.subscribes("<attach_topic>", "ignition.msgs.Empty", "attaches the child at its current pose");
    declaration.publishes("<output_topic>", "ignition.msgs.StringMsg", "`attached` or `detached`, on changes");
    declaration.sharesTopics();
  }

  void configure(const SystemContext& context) override {
    model_ = *context.model;
    world_ = &context.world;
    log_ = &context.log;
    parent_ = model_->link(parentName_);
    if (!parent_) {
      refuse(*context.sdf.child("parent_link"),
             "<parent_link> '" + parentName_ + "' is not a link of model '" + std::string(model_->name()) + "'");
    }
    const std::string prefix = "/model/" + std::string(model_->name()) + "/detachable_joint";
    const std::string child = childModel_ == "__model__" ? std::string(model_->name()) : childModel_;
    const std::string& detach = detachTopic_.empty() ? oldTopic_ : detachTopic_;
    detach_ = context.node.subscribe<ignition::msgs::Empty>(topicOr(detach, prefix + "/detach"),
                                                            [this](const auto&) { isToDetach_ = true; });
    attach_ = context.node.subscribe<ignition::msgs::Empty>(topicOr(attachTopic_, prefix + "/attach"),
                                                            [this](const auto&) { isToAttach_ = true; });
    state_ = context.node.advertise<ignition::msgs::StringMsg>(
        topicOr(stateTopic_, "/model/" + child + "/detachable_joint/state"));
  }

  void preUpdate(const StepInfo&) override {
    if (isToDetach_) detach();
    if (isToAttach_ && !joint_) attach();
    isToDetach_ = false;
  }

  void worldChanged() override {
    if (!joint_ || joint_->exists()) return;
    joint_.reset();
    tell("detached");
  }

  void reset() override {
    // a reset removes joints made at run time
    joint_.reset();
    isToAttach_ = true;
    isToDetach_ = false;
    hasWarned_ = false;
  }

  // the world saves the joint itself, and restores it before this is called
  void transfer(StateArchive& archive) override {
    JointId held = joint_ ? joint_->id() : JointId();
    archive(held.value);
    if (archive.isGiving()) joint_ = world_->joint(held);
    archive(isToAttach_);
    archive(isToDetach_);
    archive(hasWarned_);
  }

 private:
  void attach() {
    const std::optional<Link> child = findChild();
    if (!child) return;
    isToAttach_ = false;
    const Outcome<Joint> made = world_->attach(*parent_, *child);
    if (!made) return log_->warning("'" + child->scopedName() + "' can't be held: " + made.error);
    joint_ = made.value;
    tell("attached");
  }

  void detach() {
    isToAttach_ = false;
    if (!joint_) return;
    const Outcome<void> removed = world_->detach(*joint_);
    if (!removed) return log_->warning("the joint can't be removed: " + removed.error);
    joint_.reset();
    tell("detached");
  }

  /// @return The link to hold, if it is there: of a model in this one, beside it, or in the world.
  std::optional<Link> findChild() {
    std::optional<Model> model = model_;
    if (childModel_ != "__model__") {
      model = world_->model(model_->scopedName() + "::" + childModel_);
      if (!model && model_->parent()) model = world_->model(model_->parent()->scopedName() + "::" + childModel_);
      if (!model) model = world_->model(childModel_);
    }
    const std::optional<Link> link = model ? model->link(childLink_) : std::nullopt;
    if (!link && !hasWarned_ && !isQuiet_) {
      log_->warning(model ? "model '" + childModel_ + "' has no link '" + childLink_ + "' to hold"
                          : "there is no model '" + childModel_ + "' to hold yet");
    }
    hasWarned_ = !link;
    return link;
  }

  void tell(const char* state) {
    ignition::msgs::StringMsg message;
    message.set_data(state);
    state_.publish(message);
  }

  std::string parentName_, childModel_, childLink_;
  std::string detachTopic_, oldTopic_, attachTopic_, stateTopic_;
  bool isQuiet_ = false;

  std::optional<Model> model_;
  std::optional<Link> parent_;
  World* world_ = nullptr;
  const Logger* log_ = nullptr;
  std::optional<Joint> joint_;
  bool isToAttach_ = true;
  bool isToDetach_ = false;
  bool hasWarned_ = false;
  Subscription detach_;
  Subscription attach_;
  Publisher state_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::DetachableJoint, "ignition::gazebo::systems::DetachableJoint",
                      "gz::sim::systems::DetachableJoint");
