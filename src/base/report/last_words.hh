#pragma once

namespace pongsim::base {

/// Installs a handler for memory, threads or other resources running out where failure is not allowed (in a destructor,
/// in a library function): the process then says so on stderr and exits with code 1. Any other unhandled exception
/// still ends it with SIGABRT. Applies to the whole process.
void sayLastWords();

}  // namespace pongsim::base
