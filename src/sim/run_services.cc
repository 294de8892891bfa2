#include "sim/run_services.hh"

#include <utility>

#include "pongsim/simulation.hh"

namespace pongsim::sim {

RunServices::RunServices(Simulation& simulation, RunControl& control, std::function<void()> stop)
    : simulation_(simulation),
      control_(control),
      stop_(std::move(stop)),
      controlName_(cleanTopic("/world/" + std::string(simulation.world().name()) + "/control")) {
  constexpr std::string_view kBoolean = "ignition.msgs.Boolean";
  Node node = simulation.transport().node();
  worldControl_ =
      node.serve(controlName_, "ignition.msgs.WorldControl", kBoolean, [this](const Message& request, Message& reply) {
        msgs::setBoolean(controlWorld(msgs::worldControl(request)), reply);
        return true;
      });
  worlds_ = node.serve("/gazebo/worlds", "ignition.msgs.Empty", "ignition.msgs.StringMsg_V",
                       [this](const Message&, Message& reply) {
                         msgs::addString(std::string(simulation_.world().name()), reply);
                         return true;
                       });
  serverControl_ = node.serve("/server_control", "ignition.msgs.ServerControl", kBoolean,
                              [this](const Message& request, Message& reply) {
                                msgs::setBoolean(controlServer(msgs::serverControl(request)), reply);
                                return true;
                              });
}

bool RunServices::controlWorld(const msgs::WorldControl& asked) {
  const std::optional<std::string> refusal = control_.apply(asked, simulation_.time());
  if (refusal) log_.warning(controlName_ + ": " + *refusal);
  return !refusal;
}

bool RunServices::controlServer(const msgs::ServerControl& asked) {
  if (asked.more || !asked.stop) {
    log_.warning("/server_control: only 'stop: true' can be done");
    return false;
  }
  stop_();
  return true;
}

}  // namespace pongsim::sim
