#include "benchmark/robots.hh"

#include <stdexcept>

#include "pongsim/message.hh"

namespace pongsim::benchmark {

std::string withRobots(std::string text, int count) {
  const std::size_t begin = text.find("<model name='vehicle_blue'");
  const std::string closing = "</model>";
  const std::size_t end = text.find(closing, begin) + closing.size();
  const std::string robot = text.substr(begin, end - begin);
  std::string copies;
  for (int i = 1; i < count; ++i) {
    std::string copy = robot;
    copy.insert(copy.find("vehicle_blue") + std::string("vehicle_blue").size(), std::to_string(i));
    const std::size_t pose = copy.find("0 0 0 0 0 0</pose>");
    copies += copy.replace(pose, 3, "0 " + std::to_string(3 * i));
  }
  return text.insert(end, copies);
}

Link chassisOf(Simulation& simulation) {
  for (const Model& model : simulation.world().models()) {
    if (const auto link = model.link("chassis")) return *link;
  }
  throw std::runtime_error("no robot here");
}

void driveOff(Simulation& simulation, double angular) {
  const auto twist = newMessage("ignition.msgs.Twist");
  parseMessage("linear: {x: " + std::to_string(kLinear) + "}, angular: {z: " + std::to_string(angular) + "}", *twist);
  Publisher publisher = simulation.transport().node().advertise("/cmd_vel", "ignition.msgs.Twist");
  publisher.publish(*twist);
  const Link chassis = chassisOf(simulation);
  const Vector3 start = chassis.pose().position;
  simulation.step(kSettlingSteps);
  requireMoved((chassis.pose().position - start).norm());
}

void requireMoved(double distance) {
  if (!(distance > 0.15 && distance < 0.3)) {
    throw std::runtime_error("a robot went " + std::to_string(distance) + " m and not as commanded");
  }
}

}  // namespace pongsim::benchmark
