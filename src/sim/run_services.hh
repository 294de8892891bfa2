#pragma once

#include <cstdint>
#include <functional>
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

/// What others may ask of a run: `/world/W/control`, `/world/W/playback/control`, `/gazebo/worlds`, `/server_control`,
/// and what `EditServices` and `ResourceServices` offer. Requests are met from within `Transport::dispatch`, and must
/// be in between two steps.
class RunServices {
 public:
  /// @param stop Ends the run. All references must outlive it.
  RunServices(Simulation& simulation, RunControl& control, std::function<void()> stop);

 private:
  ServiceAnswer controlWorld(const msgs::WorldControl& asked);
  ServiceAnswer controlPlayback(const msgs::PlaybackControl& asked);
  ServiceAnswer reset(std::optional<std::uint64_t> seed);
  ServiceAnswer controlServer(const msgs::ServerControl& asked);

  Simulation& simulation_;
  RunControl& control_;
  std::function<void()> stop_;
  Logger log_{"run"};
  Service worldControl_;
  Service playbackControl_;
  Service worlds_;
  Service serverControl_;
  EditServices edits_;
  ResourceServices resources_;
};

}  // namespace pongsim::sim
