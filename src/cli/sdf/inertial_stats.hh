#pragma once

#include <string>

#include "description/model.hh"

namespace pongsim::cli {

/// Total mass, centre of mass and inertia of a model's links, in the model frame, as printed by `ign sdf
/// --inertial-stats`: [kg], [m], [kg m^2]. Excludes nested models.
std::string inertialStats(const description::Model& model);

}  // namespace pongsim::cli
