#pragma once

#include <string>

#include "description/model.hh"

namespace pongsim::cli {

/// Mass, centre of mass and inertia of all links of a model together, in its frame, as `ign sdf --inertial-stats`
/// prints them: [kg], [m], [kg m^2]. Nested models are not in it.
std::string inertialStats(const description::Model& model);

}  // namespace pongsim::cli
