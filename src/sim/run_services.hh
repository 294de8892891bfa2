#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "pongsim/log.hh"
#include "pongsim/node.hh"
#include "sim/edit_services.hh"
#include "sim/resource_services.hh"
#include "sim/run_control.hh"

namespace pongsim {
class Simulation;
}

namespace pongsim::sim {

/// What others may ask of the run of a world: `/world/W/control`, `/world/W/playback/control`, and what `EditServices`
/// and, for the first world of a process, `ResourceServices` offer. Requests are met from within
/// `Transport::dispatch`, and must be in between two steps.
class RunServices {
 public:
  /// All references must outlive it.
  /// @param folderAdded Told of folders that others add; empty: it is not the first world.
  RunServices(Simulation& simulation, RunControl& control, ResourceServices::FolderAdded folderAdded);

 private:
  ServiceAnswer controlWorld(const msgs::WorldControl& asked);
  ServiceAnswer controlPlayback(const msgs::PlaybackControl& asked);
  ServiceAnswer reset(std::optional<std::uint64_t> seed);

  Simulation& simulation_;
  RunControl& control_;
  Logger log_{"run"};
  Service worldControl_;
  Service playbackControl_;
  EditServices edits_;
  std::optional<ResourceServices> resources_;
};

}  // namespace pongsim::sim
