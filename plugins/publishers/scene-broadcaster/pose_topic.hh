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

/// A topic with poses, each in the frame of what holds it: of models, then of their links, then of what stands still in
/// a link or in the world, as Fortress orders them.
class PoseTopic {
 public:
  void open(Node& node, const std::string& topic) { publisher_ = node.advertise<ignition::msgs::Pose_V>(topic); }

  /// Sets of which models, with those nested in them, it tells from now on.
  /// @param isMoving Of what is not static only, and of neither visuals nor lights.
  void tellOf(const World& world, bool isMoving);

  /// Tells who listens, if anybody does.
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
