// Drives the robot of Fortress's moving robot tutorial one metre ahead, by ign-transport: it commands the wheels,
// listens to the odometry, and stops. As it was written for Gazebo Fortress it runs beside
//   pongsim run moving_robot.sdf --ign

#include <ignition/msgs/odometry.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <ignition/transport/Node.hh>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <thread>

namespace {

/// @return The exit code.
int drive() {
  ignition::transport::Node node;
  auto commands = node.Advertise<ignition::msgs::Twist>("/cmd_vel");

  std::atomic<double> distance = 0;
  std::function<void(const ignition::msgs::Odometry&)> heard = [&](const ignition::msgs::Odometry& odometry) {
    const auto& position = odometry.pose().position();
    distance = std::hypot(position.x(), position.y());
  };
  if (!node.Subscribe("/model/vehicle_blue/odometry", heard)) return 1;

  ignition::msgs::Twist command;
  command.mutable_linear()->set_x(0.5);
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (distance < 1 && std::chrono::steady_clock::now() < deadline) {
    commands.Publish(command);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  command.Clear();
  commands.Publish(command);
  // for the command to leave
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  std::printf("went %.2f m\n", distance.load());
  return distance < 1 ? 1 : 0;
}

}  // namespace

int main() {
  const int code = drive();
  // not by exit: the library's threads run on, and now and then fall over what that destroys
  std::fflush(nullptr);
  std::_Exit(code);
}
