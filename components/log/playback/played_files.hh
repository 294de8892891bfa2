#pragma once

#include <filesystem>
#include <string>

namespace pongsim::log {

/// The files of a recording to play: a folder, a zip file of one, or a single tlog file.
class PlayedFiles {
 public:
  /// Unpacks a zip file into a temporary folder of its own.
  /// @throws Failure if there is no recording.
  explicit PlayedFiles(const std::filesystem::path& path);
  /// Deletes what was unpacked.
  ~PlayedFiles();
  PlayedFiles(const PlayedFiles&) = delete;
  PlayedFiles& operator=(const PlayedFiles&) = delete;

  /// The log.
  const std::filesystem::path& stateFile() const { return stateFile_; }

  /// @param address Address of a file in the recording.
  /// @return The recording's copy of the file; if it has none, the unchanged address.
  std::string placeOf(const std::string& address) const;

 private:
  /// @param named The path as given by the user.
  void find(const std::filesystem::path& folder, const std::filesystem::path& named);

  std::filesystem::path folder_, stateFile_, unpacked_;
};

}  // namespace pongsim::log
