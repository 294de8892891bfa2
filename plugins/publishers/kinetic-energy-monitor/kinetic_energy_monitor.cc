#include <ignition/msgs/double.pb.h>

#include <algorithm>
#include <optional>
#include <string>

#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// @return Kinetic energy of a link [J].
double kineticEnergy(const Link& link, const MassInfo& mass) {
  const Quaternion q_WorldLink = link.pose().rotation;
  const Vector3 turn = q_WorldLink.conjugate() * link.angularVelocity();
  const Vector3 velocity = link.linearVelocity() + link.angularVelocity().cross(q_WorldLink * mass.center);
  return (mass.mass * velocity.squaredNorm() + turn.dot(mass.inertia * turn)) / 2;
}

/// Publishes sudden losses of a link's kinetic energy.
class KineticEnergyMonitor : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Publishes sudden losses of a link's kinetic energy.", Declaration::Place::kModel);
    declaration.parameter("link_name", &linkName_, "", "link of the model").required();
    declaration.parameter("kinetic_energy_threshold", &threshold_, "J",
                          "smallest loss within two steps that is published");
    declaration.parameter("topic", &topic_, "", "topic of the messages").otherwise("/model/M/kinetic_energy");
    declaration.publishes("<topic>", "ignition.msgs.Double", "the loss [J]");
  }

  void configure(const SystemContext& context) override {
    const Model& model = *context.model;
    link_ = model.link(linkName_);
    if (!link_) {
      refuse(*context.sdf.child("link_name"),
             "<link_name> '" + linkName_ + "' is not a link of model '" + std::string(model.name()) + "'");
    }
    mass_ = link_->mass();
    reset();
    publisher_ = context.node.advertise<ignition::msgs::Double>(
        topicOr(topic_, "/model/" + std::string(model.name()) + "/kinetic_energy"));
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused) return;
    const double energy = kineticEnergy(*link_, mass_);
    // the engine may spread an impact over two steps
    const double loss = std::max(energy_, energyBefore_) - energy;
    energyBefore_ = loss > threshold_ ? energy : energy_;
    energy_ = energy;
    if (!(loss > threshold_) || !publisher_.hasSubscribers()) return;
    message_.set_data(loss);
    publisher_.publish(message_);
  }

  void reset() override { energy_ = energyBefore_ = kineticEnergy(*link_, mass_); }

  void transfer(StateArchive& archive) override {
    archive(energy_);
    archive(energyBefore_);
  }

 private:
  std::string linkName_;
  double threshold_ = 7;
  std::string topic_;
  std::optional<Link> link_;
  MassInfo mass_;
  /// At the end of the last step, and of the one before it [J].
  double energy_ = 0;
  double energyBefore_ = 0;
  Publisher publisher_;
  ignition::msgs::Double message_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::KineticEnergyMonitor, "ignition::gazebo::systems::KineticEnergyMonitor",
                      "gz::sim::systems::KineticEnergyMonitor");
