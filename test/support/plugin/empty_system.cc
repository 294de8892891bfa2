#include "pongsim/export.hh"

// A library without a system.
extern "C" PONGSIM_API int answer();
int answer() { return 42; }
