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
  /// How many at once, 1 to 16.
  std::size_t jobs = 4;
  /// Ask the server for the newest version even if the cache has one.
  bool isUpdate = false;
  /// "Name: value", sent to the servers of the addresses that the user names, and not to those of others that these
  /// need.
  std::vector<std::string> headers = {};
};

/// What has come of an address.
struct DownloadResult {
  FuelAddress address;
  /// Whether the user named it, or one that was named needs it.
  bool isWanted = false;
  /// Where it is now. Empty: it could not be had, and this is why.
  std::filesystem::path folder;
  std::string why, hint;
};

/// Brings models and worlds into the cache, with all that they name, several at once.
///
/// Each is downloaded beside the place where it will be, checked, and moved there when it is whole. What has come of
/// one that was broken off is gone on with, if the server knows it again. Of two processes that want the same model one
/// downloads it.
class Downloads {
 public:
  /// All must outlive it.
  Downloads(const Settings& settings, const DownloadOptions& options, Progress& progress);

  /// @param addresses Each with its version or none; of files only the model counts.
  /// @return One for each, and for what they need, in the order in which they were met.
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

/// @return The models and worlds that one in the cache names and that are not part of it.
std::vector<FuelAddress> neededBy(const std::filesystem::path& folder);

/// @return The same for all addresses of a model's version, whatever the server's name.
std::string keyOf(const FuelAddress& address);

/// @return "OWNER/NAME" or "OWNER/NAME version 3"
std::string nameOf(const FuelAddress& address);

}  // namespace pongsim::fuel
