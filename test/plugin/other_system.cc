#include "pongsim/system.hh"

namespace pongsim {
// What another version had, or will have.
PONGSIM_API int functionOfAnotherVersion();
}  // namespace pongsim

// A library of another version of the interface, which wants what this one does not have.
extern "C" PONGSIM_API const pongsim::SystemTable pongsim_systems;
const pongsim::SystemTable pongsim_systems{INTERFACE_VERSION, {}};

extern "C" PONGSIM_API int wanted();
int wanted() { return pongsim::functionOfAnotherVersion(); }
