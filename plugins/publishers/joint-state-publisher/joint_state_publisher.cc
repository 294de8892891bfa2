#include <ignition/msgs/model.pb.h>

#include <optional>
#include <string>
#include <vector>

#include "pongsim/messages/fields.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Publishes positions and velocities of a model's joints.
class JointStatePublisher : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Publishes positions and velocities of a model's joints.", Declaration::Place::kModel);
    declaration.parameter("joint_name", &jointNames_, "", "joints of the model").otherwise("all joints of the model");
    declaration.parameter("topic", &topic_, "", "topic of the messages").otherwise("/world/W/model/M/joint_state");
    declaration.parameter("update_rate", &rate_, "Hz", "messages per simulated second; 0: one per step");
    declaration.publishes("<topic>", "ignition.msgs.Model", "the joints with their axes");
  }

  void configure(const SystemContext& context) override {
    const Element& sdf = context.sdf;
    model_ = *context.model;
    schedule_ = Schedule(periodOf(rate_));
    for (const Element* element : sdf.childrenNamed("joint_name")) {
      const std::optional<Joint> joint = model_->joint(element->text);
      if (joint) {
        joints_.push_back(*joint);
      } else {
        context.diagnostics.warning(
            element->position,
            "<joint_name> '" + element->text + "' is not a joint of model '" + std::string(model_->name()) + "'");
      }
    }
    if (jointNames_.empty()) joints_ = model_->joints();
    std::string topic = "/joint_state";
    for (std::optional<Model> model = model_; model; model = model->parent()) {
      topic = "/model/" + std::string(model->name()) + topic;
    }
    topic = "/world/" + std::string(context.world.name()) + topic;
    publisher_ = context.node.advertise<ignition::msgs::Model>(topicOr(topic_, topic));
    describe();
  }

  void postUpdate(const StepInfo& info) override {
    if (!info.paused && !schedule_.isDue(info.time)) return;
    if (!publisher_.hasSubscribers()) return;
    setStamp(info.time, *message_.mutable_header());
    const std::optional<Model> parent = model_->parent();
    setPose(parent ? parent->pose().inverse() * model_->pose() : model_->pose(), *message_.mutable_pose());
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (joints_[i].axisCount() == 0) continue;
      ignition::msgs::Axis& axis = *message_.mutable_joint(static_cast<int>(i))->mutable_axis1();
      axis.set_position(joints_[i].position());
      axis.set_velocity(joints_[i].velocity());
    }
    publisher_.publish(message_);
  }

  void reset() override { schedule_.reset(); }

  void transfer(StateArchive& archive) override { archive(schedule_); }

 private:
  /// Fills in what does not change.
  void describe() {
    message_.set_name(std::string(model_->name()));
    message_.set_id(static_cast<std::uint32_t>(model_->id().value));
    for (const Joint& joint : joints_) {
      ignition::msgs::Joint& message = *message_.add_joint();
      message.set_name(std::string(joint.name()));
      message.set_id(static_cast<std::uint32_t>(joint.id().value));
      setPose(joint.poseInChild(), *message.mutable_pose());
      message.set_parent(joint.parent() ? std::string(joint.parent()->name()) : "world");
      message.set_child(std::string(joint.child().name()));
      if (joint.axisCount() == 0) continue;
      const JointAxisInfo axis = joint.axisInfo();
      setVector(axis.xyz, *message.mutable_axis1()->mutable_xyz());
      message.mutable_axis1()->set_limit_lower(axis.lower);
      message.mutable_axis1()->set_limit_upper(axis.upper);
      message.mutable_axis1()->set_damping(axis.damping);
    }
  }

  std::vector<std::string> jointNames_;
  std::string topic_;
  double rate_ = 0;
  std::optional<Model> model_;
  std::vector<Joint> joints_;
  Schedule schedule_;
  Publisher publisher_;
  ignition::msgs::Model message_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::JointStatePublisher, "ignition::gazebo::systems::JointStatePublisher",
                      "gz::sim::systems::JointStatePublisher");
