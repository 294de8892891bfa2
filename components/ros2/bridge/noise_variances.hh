#pragma once

#include <map>
#include <string>

#include "pongsim/handles.hh"
#include "ros2/pairs/frames.hh"

namespace pongsim::ros2 {

/// By topic of the simulation.
using NoiseVariances = std::map<std::string, Variances>;

/// @return The variances of the `<noise>` of sensors: the squares of its standard deviations, without those of biases.
/// Sensors without noise are left out.
NoiseVariances noiseVariances(const World& world);

}  // namespace pongsim::ros2
