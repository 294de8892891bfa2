#include "sim/running/run_services.hh"

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "pongsim/scene.hh"
#include "pongsim/simulation.hh"
#include "sim/diagnostic_log.hh"

namespace pongsim::sim {

RunServices::RunServices(Simulation& simulation, RunControl& control, RunHistory& history,
                         ResourceServices::FolderAdded folderAdded)
    : simulation_(simulation), control_(control), history_(history), edits_(simulation) {
  constexpr std::string_view kBoolean = "ignition.msgs.Boolean";
  Node node = simulation.transport().node();
  const std::string controlName = cleanTopic("/world/" + std::string(simulation.world().name()) + "/control");
  worldControl_ =
      node.serve(controlName, "ignition.msgs.WorldControl", kBoolean, [this](const Message& request, Message& reply) {
        msgs::setBoolean(true, reply);
        return controlWorld(msgs::worldControl(request));
      });
  playbackControl_ =
      node.serve(cleanTopic("/world/" + std::string(simulation.world().name()) + "/playback/control"),
                 "ignition.msgs.LogPlaybackControl", kBoolean, [this](const Message& request, Message& reply) {
                   msgs::setBoolean(true, reply);
                   return controlPlayback(msgs::playbackControl(request));
                 });
  guiInfo_ = node.serve(cleanTopic("/world/" + std::string(simulation.world().name()) + "/gui/info"),
                        "ignition.msgs.Empty", "ignition.msgs.GUI", [&simulation](const Message&, Message& reply) {
                          Scene(simulation.world()).fillInGui(reply);
                          return true;
                        });
  if (folderAdded) resources_.emplace(simulation, std::move(folderAdded));
}

ServiceAnswer RunServices::controlWorld(const msgs::WorldControl& asked) {
  const bool isReset = asked.reset == msgs::Reset::kAll;
  const Outcome<void> applied = control_.apply(asked, isReset ? Time::zero() : simulation_.time());
  if (!applied) return ServiceAnswer::refused(applied.error);
  if (!isReset) return true;
  return reset(asked.seed != 0 ? std::optional<std::uint64_t>(asked.seed) : std::nullopt);
}

ServiceAnswer RunServices::controlPlayback(const msgs::PlaybackControl& asked) {
  if (asked.forward) return ServiceAnswer::refused("'forward' is not supported: seek to a time");
  if (asked.rewind && asked.seek) return ServiceAnswer::refused("rewind and seek can't be used together");
  if (asked.seek) {
    const Outcome<void> sought =
        simulation_.hasPhysics() ? history_.goTo(*asked.seek) : simulation_.setTime(*asked.seek);
    if (!sought) return ServiceAnswer::refused(sought.error);
  }
  msgs::WorldControl run = asked.run;
  if (asked.rewind) run.reset = msgs::Reset::kAll;
  control_.apply(run, asked.rewind ? Time::zero() : simulation_.time());
  return asked.rewind ? reset(std::nullopt) : true;
}

ServiceAnswer RunServices::reset(std::optional<std::uint64_t> seed) {
  Diagnostics diagnostics;
  simulation_.reset(diagnostics, seed);
  history_.forget();
  logDiagnostics(diagnostics, log_);
  return true;
}

}  // namespace pongsim::sim
