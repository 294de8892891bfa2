#pragma once

#include <string>

#include "pongsim/handles.hh"
#include "pongsim/simulation.hh"

namespace pongsim::benchmark {

/// How the robots are commanded [m/s, rad/s].
constexpr double kLinear = 0.5;
constexpr double kAngular = 0.4;

/// @param text The world of the moving-robot tutorial.
/// @return It with `count` of its robots, 3 m apart.
std::string withRobots(std::string text, int count);

/// @return The chassis of the first robot.
/// @throws std::runtime_error where there is none.
Link chassisOf(Simulation& simulation);

/// Makes steps until the robots drive as commanded.
/// @param angular [rad/s]
/// @throws std::runtime_error where the first one does not: what stands still costs nothing to compare.
void driveOff(Simulation& simulation, double angular = kAngular);

/// @throws std::runtime_error where the way [m] that a robot went in `kSettlingSteps` is not as commanded.
void requireMoved(double distance);
constexpr int kSettlingSteps = 500;

}  // namespace pongsim::benchmark
