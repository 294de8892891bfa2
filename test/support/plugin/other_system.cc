#include "pongsim/system.hh"

namespace pongsim {
// Symbols of another version of the library.
PONGSIM_API int functionOfAnotherVersion();
}  // namespace pongsim

// A library built for another version of the interface, which needs symbols that this one lacks.
extern "C" PONGSIM_API const pongsim::SystemTable pongsim_systems;
const pongsim::SystemTable pongsim_systems{INTERFACE_VERSION, {}};

extern "C" PONGSIM_API int wanted();
int wanted() { return pongsim::functionOfAnotherVersion(); }
