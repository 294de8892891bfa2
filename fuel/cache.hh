#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/files/fuel_address.hh"

namespace pongsim::fuel {

/// Keeps other processes of pongsim off a model while it is downloaded. Goes with its owner, however that ends.
class Lock {
 public:
  /// @throws Failure where the file can't be made.
  explicit Lock(const std::filesystem::path& file);
  ~Lock();
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

  /// @return False where another process has it.
  bool tryTake();
  /// Waits until it is free.
  /// @throws Interrupted
  void take();

 private:
  void open();

  std::filesystem::path file_;
  int number_ = -1;
};

/// What of a model or world is on its way, in the cache's folder ".pongsim", which Fortress does not look into.
struct Workplace {
  /// @throws Failure where the folder can't be made.
  Workplace(const FuelAddress& address, const std::filesystem::path& cache);

  std::filesystem::path lock;
  /// The zip file as far as it has come, and what was said of it: see `Part`.
  std::filesystem::path zip;
  std::filesystem::path note;
  std::filesystem::path folder;
};

/// What is known of a zip file of which a part has come.
struct Part {
  /// 0: unknown.
  int version = 0;
  /// By which the server knows the bytes again: an ETag. Empty: it can't be gone on with.
  std::string validator;
  /// Whether the bytes come from where the server led by a link in a text.
  bool isLinked = false;

  /// @return Nothing where there is none, or it can't be read.
  static std::optional<Part> read(const std::filesystem::path& file);
  void write(const std::filesystem::path& file) const;
};

/// Moves a folder to where a version belongs, whatever is there: in one go, so that nobody ever sees a part of it.
/// @throws Failure
void place(const std::filesystem::path& folder, const std::filesystem::path& target);

/// A version in the cache.
struct CachedVersion {
  FuelAddress address;
  std::filesystem::path folder;
};

/// @return All versions of all models and worlds in the order of their names, those that are not whole too.
std::vector<CachedVersion> cachedVersions(const std::filesystem::path& cache);

/// @return What is wrong with a version, each in a sentence that does not name it.
std::vector<std::string> faultsOf(const CachedVersion& version);

/// @return The SDF files that lie in a folder of a model or world itself.
std::vector<std::filesystem::path> sdfFilesIn(const std::filesystem::path& folder);

/// @return The bytes of a file, or of all files below a folder.
std::uint64_t sizeOf(const std::filesystem::path& path);

/// @throws Failure where it can't be read.
std::string textOf(const std::filesystem::path& file);
void writeText(const std::filesystem::path& file, const std::string& text);

}  // namespace pongsim::fuel
