#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pongsim::ros2 {

/// The work to do after the command line has been parsed.
/// @return The exit code.
using Work = std::function<int()>;

// Each function adds its action of `pongsim ros2` to `program`. The action sets `work` if the user names it; both must
// outlive the work. Actions are also listed in main.cc, and in share/ros2.json for help and completion.
void addCheckAction(CLI::App& program, Work& work);
void addCreateAction(CLI::App& program, Work& work);
void addNodesAction(CLI::App& program, Work& work);
void addTopicsAction(CLI::App& program, Work& work);

/// @return A command line for `create` with our options, because those of ros_gz_sim have one dash.
std::vector<std::string> wordsOfCreate(const std::vector<std::string>& words);

}  // namespace pongsim::ros2
