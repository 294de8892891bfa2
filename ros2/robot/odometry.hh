#pragma once

#include <string>
#include <vector>

#include "pongsim/handles.hh"
#include "pongsim/node.hh"

namespace pongsim::ros2 {

/// @return The topics on which systems of the model may tell where it is by their odometry, as ignition.msgs.Pose_V
/// with `frame_id` and `child_frame_id` in the headers: what `<tf_topic>` of a `<plugin>` says, and where drives and
/// the odometry publisher speak where it says nothing. Those that count more come first.
std::vector<std::string> odometryTopics(const Model& model);

/// @return The first of them on which this process publishes; empty where there is none.
std::string odometryTopic(const Model& model, const std::vector<OwnTopic>& topics);

}  // namespace pongsim::ros2
