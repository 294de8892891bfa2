// The wall avoider of Fortress's tutorial on sensors: drives ahead, and turns where a wall is near.
//     pongsim run sensor_tutorial.sdf &
//     build/wall_avoider
#include <ignition/msgs/laserscan.pb.h>
#include <ignition/msgs/twist.pb.h>
#include <pongsim/node.hh>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>

#include "command.hh"

namespace {

volatile std::sig_atomic_t stopping = 0;

}  // namespace

int main() {
  try {
    std::signal(SIGINT, [](int) { stopping = 1; });
    std::signal(SIGTERM, [](int) { stopping = 1; });
    pongsim::Transport transport;
    pongsim::Node node = transport.node();
    pongsim::Publisher commands = node.advertise<ignition::msgs::Twist>("/cmd_vel");
    const pongsim::Subscription scans = node.subscribe<ignition::msgs::LaserScan>(
        "/lidar", [&](const ignition::msgs::LaserScan& scan) { commands.publish(wall_avoider::commandFor(scan)); });
    // messages come to their functions on this thread, and nowhere else
    while (stopping == 0) transport.dispatchFor(std::chrono::milliseconds(100));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "wall_avoider: error: %s\n", error.what());
    return 1;
  }
}
