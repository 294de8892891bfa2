#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/files/fuel_address.hh"

namespace pongsim::fuel {

/// Locks a model against other pongsim processes while it is downloaded, by flock(2), which the kernel releases when
/// the process ends in any way.
class Lock {
 public:
  /// @throws Failure if the file can't be created.
  explicit Lock(const std::filesystem::path& file);
  ~Lock();
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

  /// @return False if another process holds it.
  bool tryTake();
  /// Waits until no other process holds it, and takes it.
  /// @throws Interrupted
  void take();

 private:
  void open();

  std::filesystem::path file_;
  int number_ = -1;
};

/// The files of a download in progress, in the cache's folder ".pongsim", which Fortress ignores.
struct Workplace {
  /// @throws Failure if the folder can't be created.
  Workplace(const FuelAddress& address, const std::filesystem::path& cache);

  std::filesystem::path lock;
  /// The partial zip file, and its description: see `PartialDownload`.
  std::filesystem::path zip;
  std::filesystem::path note;
  std::filesystem::path folder;
};

/// Description of a partially downloaded zip file.
struct PartialDownload {
  /// 0: unknown.
  int version = 0;
  /// An ETag that identifies the bytes on the server. Empty: it can't be continued.
  std::string validator;
  /// Whether the bytes come from a link in the server's response.
  bool isLinked = false;

  /// @return Nothing if there is none, or it can't be read.
  static std::optional<PartialDownload> read(const std::filesystem::path& file);
  void write(const std::filesystem::path& file) const;
};

/// Moves a folder to the place of a version in the cache, and replaces an existing one. Atomic (rename), so that other
/// processes see either version completely.
/// @throws Failure
void place(const std::filesystem::path& folder, const std::filesystem::path& target);

/// A version in the cache.
struct CachedVersion {
  FuelAddress address;
  std::filesystem::path folder;
};

/// @return All versions of all models and worlds, sorted by name, including incomplete ones.
std::vector<CachedVersion> cachedVersions(const std::filesystem::path& cache);

/// @return What is wrong with a version, as sentences that do not name it.
std::vector<std::string> faultsOf(const CachedVersion& version);

/// @return The SDF files directly in the folder of a model or world.
std::vector<std::filesystem::path> sdfFilesIn(const std::filesystem::path& folder);

/// @return The size of a file, or of all files below a folder [bytes].
std::uint64_t sizeOf(const std::filesystem::path& path);

/// @throws Failure if it can't be read.
std::string textOf(const std::filesystem::path& file);
void writeText(const std::filesystem::path& file, const std::string& text);

}  // namespace pongsim::fuel
