#include "cli/version.hh"

#include "physics/bullet_version.hh"
#include "sensing/embree_version.hh"
#include "transport/fast_dds_version.hh"

namespace pongsim::cli {

std::string versionText() {
  return "pongsim " PONGSIM_VERSION "\nBullet " + physics::bulletVersion() + "\nFast DDS " +
         transport::fastDdsVersion() + "\nEmbree " + sensing::embreeVersion();
}

}  // namespace pongsim::cli
