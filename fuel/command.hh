#pragma once

namespace pongsim::fuel {

/// Does what `pongsim fuel` is asked for.
/// @return 0; 1 where it failed, 2 where the command line is wrong, as all of pongsim does.
int runCommand(int argc, char** argv);

}  // namespace pongsim::fuel
