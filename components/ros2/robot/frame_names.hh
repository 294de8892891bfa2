#pragma once

#include <string>
#include <vector>

#include "pongsim/handles.hh"
#include "pongsim/sensing/sensor.hh"
#include "ros2/pairs/frames.hh"
#include "ros2/robot/kinematic_tree.hh"

namespace pongsim::ros2 {

/// @return What precedes the names of a model's links in their frames. By default the model's name and a slash:
/// "vehicle_blue/". Where the file names the frame of odometry or of a sensor by one of the links, what it writes
/// before the link's name: nothing for `<child_frame_id>base_footprint</child_frame_id>`, "robot1/" for
/// `<frame_id>robot1/base_scan</frame_id>`.
std::string linkPrefix(const Model& model, const std::vector<Sensor>& sensors);

/// Leaves to sensors the frames that their files name like their links.
///
/// A link that a fixed joint holds and that holds no other is there for its sensor: its frame is renamed, so that the
/// name is that of the sensor's place. Another link keeps its frame, and the sensor's messages are given in it.
/// @return Sentences about lidars and cameras whose messages are given in a frame that is not at their place.
std::vector<std::string> nameSensorPlaces(const std::vector<Sensor>& sensors, const Frames& frames,
                                          KinematicTree& tree);

}  // namespace pongsim::ros2
