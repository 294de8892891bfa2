#pragma once

namespace pongsim::base {

/// From now on, where memory, threads or other resources run out within something that must not fail (a destructor, a
/// function of a library), the process says so on stderr and ends with code 1. What else has no way out ends it as
/// before, with SIGABRT. For the whole process.
void sayLastWords();

}  // namespace pongsim::base
