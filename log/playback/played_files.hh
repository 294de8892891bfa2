#pragma once

#include <filesystem>
#include <string>

namespace pongsim::log {

/// The files of a recording that is played: a folder, a zip file of one, or a tlog file alone.
class PlayedFiles {
 public:
  /// Unpacks a zip file into a folder of its own among the temporary ones.
  /// @throws Failure where there is no recording.
  explicit PlayedFiles(const std::filesystem::path& path);
  /// What was unpacked goes.
  ~PlayedFiles();
  PlayedFiles(const PlayedFiles&) = delete;
  PlayedFiles& operator=(const PlayedFiles&) = delete;

  /// The log.
  const std::filesystem::path& stateFile() const { return stateFile_; }

  /// @param address Of a file, as a recording has it.
  /// @return The file in the recording, where it has a copy of it; else the address as it is.
  std::string placeOf(const std::string& address) const;

 private:
  /// @param named What the user calls it.
  void find(const std::filesystem::path& folder, const std::filesystem::path& named);

  std::filesystem::path folder_, stateFile_, unpacked_;
};

}  // namespace pongsim::log
