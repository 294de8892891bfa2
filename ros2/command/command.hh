#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pongsim::ros2 {

/// What is to be done once the command line has been read.
/// @return The exit code.
using Work = std::function<int()>;

// Each adds its action of `pongsim ros2` to `program`, which sets `work` where the user names it; both must stay until
// the work is done. It stands in the list in main.cc, too, and in share/ros2.json for help and completion.
void addCheckAction(CLI::App& program, Work& work);
void addCreateAction(CLI::App& program, Work& work);
void addNodesAction(CLI::App& program, Work& work);
void addTopicsAction(CLI::App& program, Work& work);

/// @return A command line of `create` with the options as they are here, for ros_gz_sim has them with one dash.
std::vector<std::string> wordsOfCreate(const std::vector<std::string>& words);

}  // namespace pongsim::ros2
