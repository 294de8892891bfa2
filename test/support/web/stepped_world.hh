#pragma once

#include <memory>
#include <string>

#include "pongsim/log.hh"
#include "pongsim/node.hh"
#include "pongsim/system.hh"
#include "web/world/relay.hh"

namespace pongsim::web {

/// A world for tests: topics and services without a simulation, inside this process.
class SteppedWorld {
 public:
  explicit SteppedWorld(std::shared_ptr<Worlds> worlds, const std::string& name = "w")
      : worlds_(std::move(worlds)), relay_(std::make_unique<Relay>(worlds_, name, transport_.node(), log_)) {}

  Node node() { return transport_.node(); }

  /// Runs a step of one second, which first delivers messages and requests.
  void step() {
    transport_.dispatch();
    info_.time += std::chrono::seconds(1);
    ++info_.iteration;
    relay_->update(info_);
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) step();
  }
  /// Steps until the condition is true, or for 10 s.
  template <class IsSo>
  bool stepUntil(IsSo isSo) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (!isSo()) {
      if (std::chrono::steady_clock::now() > end) return false;
      step();
    }
    return true;
  }

  /// Reports these settings.
  void reportSettings(const WorldSettings& settings) { relay_->reportSettings(settings); }

  /// Ends the world.
  void end() { relay_.reset(); }

 private:
  Transport transport_{TransportOptions{.network = false, .domain = {}, .interface = {}}};
  Logger log_{"web"};
  StepInfo info_;
  std::shared_ptr<Worlds> worlds_;
  std::unique_ptr<Relay> relay_;
};

}  // namespace pongsim::web
