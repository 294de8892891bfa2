#include "ros2/robot/robot_descriptions.hh"

#include <algorithm>

#include "pongsim/files/urdf_source.hh"
#include "ros2/robot/urdf_writer.hh"
#include "ros2/types/std_msgs.hh"

namespace pongsim::ros2 {

std::string descriptionOf(const World& world, const Robot& robot, std::vector<std::string>& warnings) {
  if (const UrdfSource* source = robot.model.urdf()) return source->text;
  UrdfText urdf = writeUrdf(world, robot.model, robot.tree);
  warnings = std::move(urdf.warnings);
  return std::move(urdf.text);
}

void RobotDescriptions::follow(const std::vector<Topic>& topics) {
  std::erase_if(told_, [&topics](const Told& told) {
    return std::ranges::find(topics, told.topic.name, &Topic::name) == topics.end();
  });
  for (const Topic& topic : topics) {
    const auto known =
        std::ranges::find_if(told_, [&topic](const Told& told) { return told.topic.name == topic.name; });
    Told& told = known != told_.end() ? *known : told_.emplace_back();
    const ModelId model = topic.robot->model.id();
    if (told.model != model) told.isTold = false;
    told.model = model;
    told.topic = topic;
    if (told.publisher != nullptr) continue;
    told.publisher = ros_.advertise<std_msgs::String>(topic.name, kLatchedQos, [this] { ++readersVersion_; });
  }
  ++readersVersion_;
}

void RobotDescriptions::preUpdate() {
  if (readersVersion_.load(std::memory_order_relaxed) == knownReaders_) return;
  knownReaders_ = readersVersion_;
  for (Told& told : told_) {
    if (told.isTold || !told.publisher->hasReaders()) continue;
    told.isTold = true;
    std::vector<std::string> warnings;
    std_msgs::String message;
    message.data = descriptionOf(world_, *told.topic.robot, warnings);
    for (const std::string& warning : warnings) {
      ros_.log().warning("the URDF of '" + told.topic.robot->name + "': " + warning);
    }
    told.publisher->publish(message);
  }
}

}  // namespace pongsim::ros2
