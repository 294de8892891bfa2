#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pongsim::fuel {

/// Default verbosity: warnings and progress.
inline constexpr int kUsualVerbosity = 3;

/// The parsed command line.
struct Options {
  std::vector<std::string> addresses;
  std::optional<std::string> url, config, type, owner;
  std::vector<std::string> headers;
  int verbosity = kUsualVerbosity;
  std::size_t jobs = 4;
  bool raw = false, cached = false, offline = false, onlyModels = false, onlyWorlds = false;
};

// The actions of `pongsim fuel`. They return the program's exit code, and throw Failure; a UsageError reports invalid
// options.
namespace actions {

int list(const Options& options);
int info(const Options& options);
int download(const Options& options);
int update(const Options& options);
/// `pongsim fuel delete`.
int remove(const Options& options);
int check(const Options& options);
/// The interface for the loader of worlds: reads addresses from standard input, one per line, and writes a line to
/// standard output for each: "ok ADDRESS", or "failed ADDRESS", the reason and a hint, separated by tabs.
int fetch(const Options& options);

}  // namespace actions

}  // namespace pongsim::fuel
