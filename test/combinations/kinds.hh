#pragma once

#include <vector>

#include "combinations/kind.hh"

namespace pongsim::test {

/// @return Kinds of models, joints, lights and actors; each type of sensor; and each system, in its example world.
std::vector<Kind> allKinds();

}  // namespace pongsim::test
