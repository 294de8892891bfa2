// vision_msgs
#include <ignition/msgs/annotated_axis_aligned_2d_box_v.pb.h>
#include <ignition/msgs/annotated_oriented_3d_box_v.pb.h>

#include <charconv>

#include "ros2/pairs/convert.hh"
#include "ros2/pairs/pairs.hh"
#include "ros2/types/vision_msgs.hh"

namespace pongsim::ros2 {

namespace {

/// A class is identified by its label, as text; one that is not a number counts as 0.
template <class Detection>
std::uint32_t labelOf(const Detection& detection) {
  std::uint32_t label = 0;
  if (!detection.results.empty()) {
    const std::string& id = detection.results.front().hypothesis.class_id;
    std::from_chars(id.data(), id.data() + id.size(), label);
  }
  return label;
}

template <class Detection>
void setLabel(std::uint32_t label, Detection& detection) {
  detection.results.resize(1);
  detection.results.front().hypothesis.class_id = std::to_string(label);
  detection.results.front().hypothesis.score = 1;
}

struct Detection2DPair {
  using Ros = vision_msgs::Detection2D;
  using Ignition = ignition::msgs::AnnotatedAxisAligned2DBox;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    setLabel(from.label(), to);
    const auto& low = from.box().min_corner();
    const auto& high = from.box().max_corner();
    to.bbox.center.position = {(low.x() + high.x()) / 2, (low.y() + high.y()) / 2};
    to.bbox.size_x = high.x() - low.x();
    to.bbox.size_y = high.y() - low.y();
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    to.set_label(labelOf(from));
    const vision_msgs::Point2D& center = from.bbox.center.position;
    to.mutable_box()->mutable_min_corner()->set_x(center.x - from.bbox.size_x / 2);
    to.mutable_box()->mutable_min_corner()->set_y(center.y - from.bbox.size_y / 2);
    to.mutable_box()->mutable_max_corner()->set_x(center.x + from.bbox.size_x / 2);
    to.mutable_box()->mutable_max_corner()->set_y(center.y + from.bbox.size_y / 2);
  }
};

struct Detection3DPair {
  using Ros = vision_msgs::Detection3D;
  using Ignition = ignition::msgs::AnnotatedOriented3DBox;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    setLabel(from.label(), to);
    ros2::convert(from.box().center(), to.bbox.center.position);
    ros2::convert(from.box().orientation(), to.bbox.center.orientation);
    ros2::convert(from.box().boxsize(), to.bbox.size);
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    to.set_label(labelOf(from));
    ros2::convert(from.bbox.center.position, *to.mutable_box()->mutable_center());
    ros2::convert(from.bbox.center.orientation, *to.mutable_box()->mutable_orientation());
    ros2::convert(from.bbox.size, *to.mutable_box()->mutable_boxsize());
  }
};

/// Converts lists of a type that another pair converts.
template <class RosType, class IgnitionType, class Element>
struct ListPair {
  using Ros = RosType;
  using Ignition = IgnitionType;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    to.detections.resize(static_cast<std::size_t>(from.annotated_box_size()));
    for (int i = 0; i < from.annotated_box_size(); ++i) {
      Element::convert(from.annotated_box(i), to.detections[static_cast<std::size_t>(i)], frames);
    }
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    to.clear_annotated_box();
    for (const auto& detection : from.detections) Element::convert(detection, *to.add_annotated_box(), frames);
  }
};

}  // namespace

std::vector<Pair> visionPairs() {
  return {pairOf<Detection2DPair>(Choice::kDefault),
          pairOf<ListPair<vision_msgs::Detection2DArray, ignition::msgs::AnnotatedAxisAligned2DBox_V, Detection2DPair>>(
              Choice::kDefault),
          pairOf<Detection3DPair>(Choice::kDefault),
          pairOf<ListPair<vision_msgs::Detection3DArray, ignition::msgs::AnnotatedOriented3DBox_V, Detection3DPair>>(
              Choice::kDefault)};
}

}  // namespace pongsim::ros2
