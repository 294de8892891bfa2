#include "web/world/queue_depth.hh"

#include <algorithm>

namespace pongsim::web {

namespace {

constexpr std::string_view kStates[] = {
    "ignition.msgs.CameraInfo", "ignition.msgs.Clock",
    "ignition.msgs.Contacts",   "ignition.msgs.Image",
    "ignition.msgs.LaserScan",  "ignition.msgs.LogicalCameraImage",
    "ignition.msgs.PointCloud", "ignition.msgs.PointCloudPacked",
    "ignition.msgs.Pose_V",     "ignition.msgs.WorldStatistics",
};
// a quarter of a second of an IMU at 1 kHz
constexpr std::size_t kMostEvents = 256;
// each changes one of them: as many as a world may have
constexpr std::size_t kMostMarkers = 10'000;

}  // namespace

std::size_t queueDepth(std::string_view messageType) {
  if (messageType == "ignition.msgs.Marker") return kMostMarkers;
  return std::ranges::find(kStates, messageType) != std::end(kStates) ? 1 : kMostEvents;
}

}  // namespace pongsim::web
