#include "physics/bullet_version.hh"

#include <LinearMath/btScalar.h>

namespace pongsim::physics {

std::string bulletVersion() {
  return std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100);
}

}  // namespace pongsim::physics
