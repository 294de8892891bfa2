#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pongsim::fuel {

/// How much is said: warnings and progress.
inline constexpr int kUsualVerbosity = 3;

/// What the command line says.
struct Options {
  std::vector<std::string> addresses;
  std::optional<std::string> url, config, type, owner;
  std::vector<std::string> headers;
  int verbosity = kUsualVerbosity;
  std::size_t jobs = 4;
  bool raw = false, cached = false, offline = false, onlyModels = false, onlyWorlds = false;
};

// What the actions of `pongsim fuel` do. They return the program's exit code, and throw Failure, of which UsageError
// says that the options can't be meant.
namespace actions {

int list(const Options& options);
int info(const Options& options);
int download(const Options& options);
int update(const Options& options);
/// `pongsim fuel delete`.
int remove(const Options& options);
int check(const Options& options);
/// What the loader of worlds asks for: addresses come by standard input, a line each, and what has come of them goes to
/// standard output, a line each: "ok ADDRESS" or "failed ADDRESS", why and advice with tabs between them.
int fetch(const Options& options);

}  // namespace actions

}  // namespace pongsim::fuel
