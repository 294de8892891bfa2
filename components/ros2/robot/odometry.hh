#pragma once

#include <string>
#include <vector>

#include "pongsim/handles.hh"
#include "pongsim/node.hh"

namespace pongsim::ros2 {

/// @return The topics on which systems of the model may publish its pose from odometry, as ignition.msgs.Pose_V with
/// `frame_id` and `child_frame_id` in the headers: the `<tf_topic>` of each `<plugin>`, or the default topic of drives
/// and the odometry publisher. The most relevant ones come first.
std::vector<std::string> odometryTopics(const Model& model);

/// @return The first of them on which this process publishes; empty if there is none.
std::string odometryTopic(const Model& model, const std::vector<OwnTopic>& topics);

}  // namespace pongsim::ros2
