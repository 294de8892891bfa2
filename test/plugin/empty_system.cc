#include "pongsim/export.hh"

// A library that is no system at all.
extern "C" PONGSIM_API int answer();
int answer() { return 42; }
