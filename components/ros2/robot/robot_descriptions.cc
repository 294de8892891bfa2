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
  std::erase_if(descriptions_, [&topics](const Description& description) {
    return std::ranges::find(topics, description.topic.name, &Topic::name) == topics.end();
  });
  for (const Topic& topic : topics) {
    const auto known = std::ranges::find_if(
        descriptions_, [&topic](const Description& description) { return description.topic.name == topic.name; });
    Description& description = known != descriptions_.end() ? *known : descriptions_.emplace_back();
    const ModelId model = topic.robot->model.id();
    if (description.model != model) description.isPublished = false;
    description.model = model;
    description.topic = topic;
    if (description.publisher != nullptr) continue;
    description.publisher = ros_.advertise<std_msgs::String>(topic.name, kLatchedQos, [this] { ++readersVersion_; });
  }
  ++readersVersion_;
}

void RobotDescriptions::preUpdate() {
  if (readersVersion_.load(std::memory_order_relaxed) == knownReaders_) return;
  knownReaders_ = readersVersion_;
  for (Description& description : descriptions_) {
    if (description.isPublished || !description.publisher->hasReaders()) continue;
    description.isPublished = true;
    std::vector<std::string> warnings;
    std_msgs::String message;
    message.data = descriptionOf(world_, *description.topic.robot, warnings);
    for (const std::string& warning : warnings) {
      ros_.log().warning("the URDF of '" + description.topic.robot->name + "': " + warning);
    }
    description.publisher->publish(message);
  }
}

}  // namespace pongsim::ros2
