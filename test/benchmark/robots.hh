#pragma once

#include <string>

#include "pongsim/handles.hh"
#include "pongsim/simulation.hh"

namespace pongsim::benchmark {

/// Commanded velocities of the robots [m/s, rad/s].
constexpr double kLinear = 0.5;
constexpr double kAngular = 0.4;

/// @param text The world of the moving-robot tutorial.
/// @return The world with `count` robots, 3 m apart.
std::string withRobots(std::string text, int count);

/// @return The chassis of the first robot.
/// @throws std::runtime_error if there is none.
Link chassisOf(Simulation& simulation);

/// Makes steps until the robots drive at the commanded velocity.
/// @param angular [rad/s]
/// @throws std::runtime_error if the first one does not: the cost of robots at rest would be no comparison.
void driveOff(Simulation& simulation, double angular = kAngular);

/// @param distance Distance that a robot drove in `kSettlingSteps` [m].
/// @throws std::runtime_error if it is not as commanded.
void requireMoved(double distance);
constexpr int kSettlingSteps = 500;

}  // namespace pongsim::benchmark
