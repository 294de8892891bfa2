#pragma once

#include <foxglove/transforms.pb.h>
#include <ignition/msgs/pose_v.pb.h>
#include <ignition/msgs/scene.pb.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pongsim::web::typed {

/// The frames of a scene: "rover", "rover::chassis", "rover::chassis::lidar", each relative to its parent, models
/// relative to "world".
class Frames {
 public:
  explicit Frames(const ignition::msgs::Scene& scene);

  /// @param poses Of models and links by id, each in its parent's frame, as published by a world.
  /// @return Their frames, and those of all sensors, which are fixed to their links.
  ::foxglove::FrameTransforms transforms(const ignition::msgs::Pose_V& poses, std::uint64_t timeNs) const;

 private:
  struct Frame {
    std::string name;
    std::string parent;
  };
  struct Fixed {
    Frame frame;
    ignition::msgs::Pose pose;
  };

  void add(const ignition::msgs::Model& model, const Frame& frame);

  std::map<std::uint32_t, Frame> moving_;
  std::vector<Fixed> fixed_;
};

}  // namespace pongsim::web::typed
