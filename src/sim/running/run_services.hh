#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "pongsim/log.hh"
#include "pongsim/node.hh"
#include "sim/edits/edit_services.hh"
#include "sim/resource_services.hh"
#include "sim/running/run_control.hh"
#include "sim/running/run_history.hh"

namespace pongsim {
class Simulation;
}

namespace pongsim::sim {

/// Services for running a world: `/world/W/control`, `/world/W/playback/control`, `/world/W/gui/info`, and those of
/// `EditServices` and, for the first world of a process, `ResourceServices`. Requests are handled within
/// `Transport::dispatch`, which must be called between two steps.
class RunServices {
 public:
  /// All references must outlive this.
  /// @param folderAdded Called with folders added by requests; empty: not the first world.
  RunServices(Simulation& simulation, RunControl& control, RunHistory& history,
              ResourceServices::FolderAdded folderAdded);

 private:
  ServiceAnswer controlWorld(const msgs::WorldControl& asked);
  ServiceAnswer controlPlayback(const msgs::PlaybackControl& asked);
  ServiceAnswer reset(std::optional<std::uint64_t> seed);

  Simulation& simulation_;
  RunControl& control_;
  RunHistory& history_;
  Logger log_{"run"};
  Service worldControl_;
  Service playbackControl_;
  Service guiInfo_;
  EditServices edits_;
  std::optional<ResourceServices> resources_;
};

}  // namespace pongsim::sim
