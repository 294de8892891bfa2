#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "pongsim/simulation.hh"
#include "sim/runner.hh"
#include "sim/server_services.hh"

namespace pongsim::sim {

/// Runs worlds beside each other, each on a thread of its own and at its own pace; a single one on the thread that
/// calls `run`. Each has a `Runner`. What is there once for a process, as `/clock` and the resource folders, is the
/// first world's. A world that has made its steps is over: its topics and services end, while the others go on.
class Server {
 public:
  /// @param transport Gets the services of the process; that of the simulation where it is one, else the one in which
  /// each of the simulations has a share.
  /// @param worlds Not none. All references must outlive it.
  Server(Transport& transport, const std::vector<std::unique_ptr<Simulation>>& worlds, const RunOptions& options);
  ~Server();

  /// Runs until all have made their steps, or `stop` was called, by a request to `/server_control`, too. Where one
  /// fails, all end.
  /// @throws What the first of the worlds that fail throws.
  void run();

  /// Ends `run` soon. May be called from any thread.
  void stop();

 private:
  void runBeside();
  void addFolder(const std::filesystem::path& folder);

  Transport& transport_;
  const std::vector<std::unique_ptr<Simulation>>& worlds_;
  std::vector<std::unique_ptr<Runner>> runners_;
  std::optional<ServerServices> services_;
  std::atomic<std::size_t> running_ = 0;
};

}  // namespace pongsim::sim
