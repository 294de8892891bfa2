#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fuel/progress.hh"
#include "fuel/server.hh"
#include "fuel/settings.hh"
#include "pongsim/files/fuel_address.hh"

namespace pongsim::fuel {

struct DownloadOptions {
  /// Number of parallel downloads, 1 to 16.
  std::size_t jobs = 4;
  /// Whether to ask the server for the newest version even if the cache has one.
  bool isUpdate = false;
  /// "Name: value", sent only to the servers of the addresses given by the user, not to those of dependencies.
  std::vector<std::string> headers = {};
};

/// The result for an address.
struct DownloadResult {
  FuelAddress address;
  /// Whether the user asked for it; else it is a dependency.
  bool isWanted = false;
  /// Its folder. Empty on failure, with the reason in `why`.
  std::filesystem::path folder;
  std::string why, hint;
};

/// Downloads models and worlds into the cache, with their dependencies, several in parallel.
///
/// Each is downloaded to the folder .pongsim of the cache, checked, and moved into place when it is complete. An
/// interrupted download is continued if the server still has the same bytes (ETag, Last-Modified). If several processes
/// want the same model, one downloads it, and the others wait.
class Downloads {
 public:
  /// All references must outlive it.
  Downloads(const Settings& settings, const DownloadOptions& options, Progress& progress);

  /// @param addresses With or without a version; the address of a file stands for its model.
  /// @return A result for each, and for each dependency, in the order in which they were found.
  /// @throws Interrupted
  std::vector<DownloadResult> run(const std::vector<FuelAddress>& addresses);

 private:
  struct Queue;
  void work(Queue& queue);
  std::filesystem::path bring(const FuelAddress& address, bool isWanted);
  std::filesystem::path bringFrom(FuelServer& server, FuelAddress address);
  void loadZip(FuelServer& server, FuelAddress& address, const struct Workplace& workplace);
  void loadOnce(FuelServer& server, FuelAddress& address, const struct Workplace& workplace);

  const Settings& settings_;
  const DownloadOptions& options_;
  Progress& progress_;
};

/// @return The other models and worlds that one in the cache refers to.
std::vector<FuelAddress> neededBy(const std::filesystem::path& folder);

/// @return A key that is the same for all addresses of a version of a model, under either name of the server.
std::string keyOf(const FuelAddress& address);

/// @return "OWNER/NAME" or "OWNER/NAME version 3"
std::string nameOf(const FuelAddress& address);

}  // namespace pongsim::fuel
