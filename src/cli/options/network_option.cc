#include "cli/options/network_option.hh"

#include <CLI/App.hpp>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "shared/program/failure.hh"
#include "transport/udp/interfaces.hh"

namespace pongsim::cli {

void addNetworkOption(CLI::App& command) {
  const auto open = [](const std::string& interface) {
    if (interface.empty()) throw UsageError("option '--network' takes an interface's name or address, not ''");
    try {
      transport::chosenInterface(interface);
    } catch (const std::invalid_argument& error) {
      throw UsageError(error.what());
    }
    setenv("PONGSIM_NETWORK", interface.c_str(), 1);
  };
  command
      .add_option_function<std::string>("--network", open,
                                        "Also communicate over this network interface (name or address). Without\n"
                                        "--secure, anybody on that network can take part")
      ->type_name("INTERFACE");
}

}  // namespace pongsim::cli
