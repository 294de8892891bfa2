#pragma once

namespace pongsim::base {

/// Installs a handler for exceptions that nothing catches, such as those thrown in a destructor. If memory, threads or
/// another resource of the system have run out, the process says so on stderr and exits with code 1. Any other
/// exception still ends it with SIGABRT. Applies to the whole process.
void installTerminateHandler();

}  // namespace pongsim::base
