#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "pongsim/simulation.hh"
#include "sim/running/runner.hh"
#include "sim/running/server_services.hh"

namespace pongsim::sim {

/// Runs several worlds at once, each on its own thread and at its own pace; a single world runs on the thread that
/// calls `run`. Each world has a `Runner`. What exists once per process, such as `/clock` and the resource folders,
/// belongs to the first world. When a world has made its steps, its topics and services end, while the others continue.
class Server {
 public:
  /// @param transport For the services of the process: the transport of a single simulation, else the one that all
  /// simulations share.
  /// @param worlds At least one. All references must outlive this.
  Server(Transport& transport, const std::vector<std::unique_ptr<Simulation>>& worlds, const RunOptions& options);
  ~Server();

  /// Runs until all worlds have made their steps, or `stop` is called, also by a request to `/server_control`. If a
  /// world fails, all worlds end.
  /// @throws The exception of the first world that failed.
  void run();

  /// @return Why a world could not go on: the first one's reason.
  Outcome<void> outcome() const;

  /// Makes `run` end soon. Thread-safe.
  void stop();

 private:
  void runBeside();
  /// @param failure The exception that ends the world's thread.
  /// @throws std::runtime_error if the thread can't be started.
  std::thread startBeside(std::size_t world, std::exception_ptr& failure);
  void addFolder(const std::filesystem::path& folder);

  Transport& transport_;
  const std::vector<std::unique_ptr<Simulation>>& worlds_;
  std::vector<std::unique_ptr<Runner>> runners_;
  std::optional<ServerServices> services_;
  std::atomic<std::size_t> running_ = 0;
};

}  // namespace pongsim::sim
