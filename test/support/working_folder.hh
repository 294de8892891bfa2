#pragma once

#include <filesystem>

#include "support/temp_folder.hh"

namespace pongsim::test {

/// A folder of its own that the process works in, for as long as this lives: for what writes into the current folder.
class WorkingFolder {
 public:
  WorkingFolder() : before_(std::filesystem::current_path()) { std::filesystem::current_path(folder_.path()); }
  ~WorkingFolder() { std::filesystem::current_path(before_); }
  WorkingFolder(const WorkingFolder&) = delete;
  WorkingFolder& operator=(const WorkingFolder&) = delete;

  const std::filesystem::path& path() const { return folder_.path(); }

 private:
  TempFolder folder_;
  std::filesystem::path before_;
};

}  // namespace pongsim::test
