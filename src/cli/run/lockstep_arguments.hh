#pragma once

#include <optional>
#include <string>

#include "pongsim/lockstep_run.hh"

namespace CLI {
class App;
}

namespace pongsim::cli {

/// The options `--lockstep` and those that belong to it.
class LockstepArguments {
 public:
  void addTo(CLI::App& run);

  /// @return What they ask for, if they do.
  /// @throws UsageError where one needs another.
  std::optional<LockstepOptions> check() const;

 private:
  LockstepOptions options_;
  /// An option that has an effect only with `--lockstep`, or empty.
  std::string dependent_;
};

}  // namespace pongsim::cli
