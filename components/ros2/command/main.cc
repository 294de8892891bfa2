// pongsim-ros2, which `pongsim ros2` runs.
#include "ros2/command/command.hh"

namespace {

constexpr pongsim::cli::AddCommand kActions[] = {
    pongsim::ros2::addTopicsAction,
    pongsim::ros2::addNodesAction,
    pongsim::ros2::addDoctorAction,
    pongsim::ros2::addCreateAction,
    pongsim::ros2::addCheckAction,
};

constexpr pongsim::cli::Program kProgram{
    .name = "pongsim ros2",
    .about = "Inspects ROS 2 nodes, and what a simulation bridges to them.",
    .commands = kActions,
    .footer =
        "Environment:\n"
        "  ROS_DOMAIN_ID       ROS domain, 0 to 232 (0)\n"
        "  ROS_DISTRO          ROS distribution of the nodes: humble (default), jazzy...\n"
        "  ROS_LOCALHOST_ONLY  1: only nodes that use 127.0.0.1",
    .words = pongsim::ros2::withTwoDashesForCreate};

}  // namespace

int main(int argc, char** argv) { return pongsim::cli::run(argc, argv, kProgram); }
