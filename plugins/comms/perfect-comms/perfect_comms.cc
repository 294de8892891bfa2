#include "pongsim/comms_system.hh"

namespace pongsim {

namespace {

/// Carries every message between robots.
class PerfectComms : public CommsSystem {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Carries messages between robots without loss.", Declaration::Place::kWorld);
    CommsSystem::declare(declaration);
  }

 protected:
  bool carries(const Radio&, const Radio&, Time, ignition::msgs::Dataframe&) override { return true; }
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::PerfectComms, "ignition::gazebo::systems::PerfectComms",
                      "gz::sim::systems::PerfectComms");
