#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/outcome.hh"

namespace pongsim::base {

/// How a child process ended.
struct ChildResult {
  /// What it wrote to its standard output.
  std::string output;
  /// As from waitpid(2).
  int status = 0;
};

/// Runs a program and waits for its end. It has default signal handling, because this process may have blocked or
/// ignored the signals that end it.
/// @param input File descriptor of its standard input; unset: that of this process.
/// @return How it ended, or "PROGRAM can't be run: REASON".
Outcome<ChildResult> runChild(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                              std::optional<int> input = std::nullopt);

}  // namespace pongsim::base
