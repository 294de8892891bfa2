// pongsim-ros2, which `pongsim ros2` runs.
#include "ros2/command/command.hh"
#include "ros2/command/command_line.hh"

namespace {

constexpr pongsim::ros2::AddAction kActions[] = {
    pongsim::ros2::addTopicsAction,
    pongsim::ros2::addNodesAction,
    pongsim::ros2::addCreateAction,
    pongsim::ros2::addCheckAction,
};

}  // namespace

int main(int argc, char** argv) { return pongsim::ros2::run(argc, argv, kActions); }
