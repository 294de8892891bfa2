#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>

#include "pongsim/outcome.hh"

namespace pongsim::video {

/// A new file that a recording is written into. It has a name of its own, which ends in ".part", until it is complete.
class OutputFile {
 public:
  /// Creates it, and the folders that it is in.
  /// @param place Where it is when it is complete.
  static Outcome<OutputFile> create(const std::filesystem::path& place);

  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  /// Removes it, if it is not complete.
  ~OutputFile();

  // As libavformat wants them: a negative number for an error.
  int write(std::span<const std::uint8_t> bytes);
  std::int64_t seek(std::int64_t offset, int whence);

  /// @return Why a write failed, "No space left on device"; empty if none has.
  const std::string& error() const { return error_; }
  const std::filesystem::path& place() const { return place_; }

  /// Gives it its name. A file that has come to be there meanwhile stays.
  Outcome<void> complete();

 private:
  OutputFile(int file, std::filesystem::path place) : file_(file), place_(std::move(place)) {}

  int file_;
  std::filesystem::path place_;
  std::string error_;
};

/// @return "outer_inner" of the scoped name "outer::inner".
std::string fileNameOf(std::string scopedName);

/// @param folder Where files may be written, also below it.
/// @param wanted A path in it, absolute or not.
/// @param ending ".mp4"
/// @return Where a new file with that path is to be, with all links followed; a reason if that is not below the folder,
/// has another ending, or is there already.
Outcome<std::filesystem::path> placeOf(const std::filesystem::path& wanted, const std::filesystem::path& folder,
                                       const std::string& ending);

}  // namespace pongsim::video
