// The wall avoider of Fortress's tutorial on sensors: drives ahead, and turns where a wall is near.
//     pongsim run sensor_tutorial.sdf &
//     build/wall_avoider
#include <ignition/msgs/laserscan.pb.h>
#include <ignition/msgs/twist.pb.h>
#include <pongsim/node.hh>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>

namespace {

constexpr double kNear = 1.0;   // [m]
constexpr double kAhead = 0.5;  // [m/s]
constexpr double kTurn = 0.5;   // [rad/s]

volatile std::sig_atomic_t stopping = 0;

ignition::msgs::Twist commandFor(const ignition::msgs::LaserScan& scan) {
  const bool isFree = std::none_of(scan.ranges().begin(), scan.ranges().end(), [](double r) { return r < kNear; });
  ignition::msgs::Twist command;
  command.mutable_linear()->set_x(isFree ? kAhead : 0);
  command.mutable_angular()->set_z(isFree ? 0 : kTurn);
  return command;
}

}  // namespace

int main() {
  try {
    std::signal(SIGINT, [](int) { stopping = 1; });
    std::signal(SIGTERM, [](int) { stopping = 1; });
    pongsim::Transport transport;
    pongsim::Node node = transport.node();
    pongsim::Publisher commands = node.advertise<ignition::msgs::Twist>("/cmd_vel");
    const pongsim::Subscription scans = node.subscribe<ignition::msgs::LaserScan>(
        "/lidar", [&](const ignition::msgs::LaserScan& scan) { commands.publish(commandFor(scan)); });
    // messages come to their functions on this thread, and nowhere else
    while (stopping == 0) transport.dispatchFor(std::chrono::milliseconds(100));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "wall_avoider: error: %s\n", error.what());
    return 1;
  }
}
