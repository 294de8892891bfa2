#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ros2/pairs/pair.hh"

namespace pongsim::ros2 {

// One list for each file of pairs.
std::vector<Pair> basicPairs();
std::vector<Pair> geometryPairs();
std::vector<Pair> gzPairs();
std::vector<Pair> imagePairs();
std::vector<Pair> motionPairs();
std::vector<Pair> sensorPairs();
std::vector<Pair> visionPairs();

/// @return All existing pairs.
std::span<const Pair> allPairs();

/// @param ros "sensor_msgs/msg/LaserScan"; @param ignition "ignition.msgs.LaserScan", or any form that
/// `messageTypeName` accepts.
/// @return The pair, or null.
const Pair* findPair(std::string_view ros, std::string_view ignition);
/// @return The default pair for topics of this ignition type, or null.
const Pair* defaultPair(std::string_view ignition);

}  // namespace pongsim::ros2
