#include "cli/help/version.hh"

#include <CLI/App.hpp>

#include "cli/command.hh"
#include "physics/bullet_version.hh"
#include "rendering/mesa_version.hh"
#include "sensing/embree_version.hh"
#include "transport/network/fast_dds_version.hh"

namespace pongsim::cli {

std::string versionText() {
  return "pongsim " PONGSIM_VERSION "\nBullet " + physics::bulletVersion() + "\nFast DDS " +
         transport::fastDdsVersion() + "\nEmbree " + sensing::embreeVersion() + "\nMesa " + rendering::mesaVersion();
}

void addVersionOption(CLI::App& program, Work&) {
  program.set_version_flag("--version", versionText,
                           "Print the version, and those of the libraries that affect results, and exit");
}

}  // namespace pongsim::cli
