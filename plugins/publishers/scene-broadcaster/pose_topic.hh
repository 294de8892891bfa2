#pragma once

#include <ignition/msgs/pose_v.pb.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/handles.hh"
#include "pongsim/node.hh"
#include "pongsim/scene.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// A topic with poses relative to the parents: models, then their links, then what is fixed in a link or in the world,
/// in Fortress's order.
class PoseTopic {
 public:
  void open(Node& node, const std::string& topic) { publisher_ = node.advertise<ignition::msgs::Pose_V>(topic); }

  /// Selects the models to publish, with their nested models.
  /// @param isMoving Leaves out what is static, visuals and lights.
  void tellOf(const World& world, bool isMoving);

  /// Publishes, if there are subscribers.
  void publish(Time time);

 private:
  void addModel(const Model& model, bool isMoving);
  ignition::msgs::Pose& add(std::string_view name, std::uint64_t id);

  Publisher publisher_;
  std::vector<Model> models_;
  std::vector<Link> links_;
  ignition::msgs::Pose_V message_;
};

}  // namespace pongsim
