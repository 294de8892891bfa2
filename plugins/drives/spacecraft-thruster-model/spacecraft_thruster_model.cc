#include <optional>
#include <string>

#include "pongsim/control/setpoint.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Fires a thruster for a commanded part of each cycle.
class SpacecraftThrusterModel : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Fires a thruster of a spacecraft for a commanded part of each cycle.", Declaration::Place::kModel);
    declaration.parameter("link_name", &linkName_, "", "link of the thruster, which pushes along its z axis")
        .required();
    declaration.parameter("actuator_number", &actuator_, "", "index in the command").atLeast(0);
    declaration.parameter("max_thrust", &thrust_, "N", "thrust while it fires").required();
    declaration.parameter("duty_cycle_frequency", &frequency_, "Hz", "cycles per second").above(0);
    declaration.parameter("topic", &topic_, "", "command topic, or its prefix").otherwise("M");
    declaration.parameter("sub_topic", &subTopic_, "", "the command topic is `TOPIC/SUB_TOPIC`").otherwise("none");
    declaration.subscribes("<topic>", "ignition.msgs.Actuators",
                           "`normalized[actuator_number]`, the part of each cycle in which it fires, 0 to 1");
  }

  void configure(const SystemContext& context) override {
    const Model& model = *context.model;
    link_ = requiredLink(context.sdf, "link_name", model);
    if (context.sdf.child("actuator_number") == nullptr) {
      context.diagnostics.warning(context.sdf.position, "a thruster without an <actuator_number> has the number 0");
    }
    period_ = periodOf(frequency_);
    const std::string topic = topic_.empty() ? std::string(model.name()) : topic_;
    duty_.listenToActuators(context.node, context.log, cleanTopic(subTopic_.empty() ? topic : topic + "/" + subTopic_),
                            Setpoint::Kind::kNormalized, actuator_, 0);
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    if (!(duty_.value() > 0)) return;
    if (info.time - start_ > period_) start_ = info.time;
    // as in Gazebo, a step at the limit of the part belongs to it
    if (toSeconds(info.time - start_) > duty_.value() * toSeconds(period_)) return;
    // a force at the centre of mass
    const Quaternion rotation = link_->pose().rotation;
    const Vector3 force = rotation * Vector3(0, 0, thrust_);
    link_->addWrench(force, (rotation * link_->mass().center).cross(force));
  }

  void reset() override {
    start_ = Time::zero();
    duty_.reset();
  }

  void transfer(StateArchive& archive) override {
    archive(start_);
    archive(duty_);
  }

 private:
  std::string linkName_, topic_, subTopic_;
  int actuator_ = 0;
  double thrust_ = 0;
  double frequency_ = 10;

  std::optional<Link> link_;
  Time period_{0};
  /// Of the cycle.
  Time start_{0};
  Setpoint duty_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::SpacecraftThrusterModel, "gz::sim::systems::SpacecraftThrusterModel",
                      "ignition::gazebo::systems::SpacecraftThrusterModel");
