#pragma once

#include "pongsim/handles.hh"
#include "python_process.hh"

namespace pongsim {

/// Answers what a system in Python asks of the world: "KIND.WHAT ID MORE...", such as "link.add_wrench 7 0 0 1 0 0 0".
/// Numbers are in SI units and the world frame, unless `gazebo_host.py` says otherwise.
/// @throws std::runtime_error if the entity is not there, or does not do it.
Words answerRequest(World& world, const Words& request);

}  // namespace pongsim
