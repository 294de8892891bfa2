#include "cli/options/offline_option.hh"

#include <CLI/App.hpp>
#include <cstdlib>

namespace pongsim::cli {

CLI::Option* addOfflineOption(CLI::App& command) {
  return command
      .add_flag_callback(
          "--offline", [] { setenv("PONGSIM_OFFLINE", "1", 1); },
          "Download nothing: take Fuel models from the local cache")
      ->disable_flag_override();
}

}  // namespace pongsim::cli
