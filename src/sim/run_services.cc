#include "sim/run_services.hh"

#include <cstdint>
#include <optional>
#include <utility>

#include "pongsim/simulation.hh"
#include "sim/diagnostic_log.hh"

namespace pongsim::sim {

RunServices::RunServices(Simulation& simulation, RunControl& control, ResourceServices::FolderAdded folderAdded)
    : simulation_(simulation), control_(control), edits_(simulation) {
  Node node = simulation.transport().node();
  const std::string controlName = cleanTopic("/world/" + std::string(simulation.world().name()) + "/control");
  worldControl_ = node.serve(controlName, "ignition.msgs.WorldControl", "ignition.msgs.Boolean",
                             [this](const Message& request, Message& reply) {
                               msgs::setBoolean(true, reply);
                               return controlWorld(msgs::worldControl(request));
                             });
  if (folderAdded) resources_.emplace(simulation, std::move(folderAdded));
}

ServiceAnswer RunServices::controlWorld(const msgs::WorldControl& asked) {
  const bool isReset = asked.reset == msgs::Reset::kAll;
  const std::optional<std::string> refusal = control_.apply(asked, isReset ? Time::zero() : simulation_.time());
  if (refusal) return ServiceAnswer::refused(*refusal);
  if (!isReset) return true;
  Diagnostics diagnostics;
  simulation_.reset(diagnostics, asked.seed != 0 ? std::optional<std::uint64_t>(asked.seed) : std::nullopt);
  logDiagnostics(diagnostics, log_);
  return true;
}

}  // namespace pongsim::sim
