#include "pongsim/system.hh"

// A library of an interface that is no more.
extern "C" PONGSIM_API const pongsim::SystemTable pongsim_systems;
const pongsim::SystemTable pongsim_systems{0, {}};
