// ros_gz_interfaces
#include <ignition/msgs/altimeter.pb.h>
#include <ignition/msgs/contacts.pb.h>
#include <ignition/msgs/dataframe.pb.h>
#include <ignition/msgs/entity_wrench.pb.h>
#include <ignition/msgs/float_v.pb.h>
#include <ignition/msgs/gui_camera.pb.h>
#include <ignition/msgs/light.pb.h>
#include <ignition/msgs/param_v.pb.h>
#include <ignition/msgs/sensor_noise.pb.h>
#include <ignition/msgs/stringmsg_v.pb.h>
#include <ignition/msgs/track_visual.pb.h>
#include <ignition/msgs/video_record.pb.h>
#include <ignition/msgs/world_control.pb.h>

#include <charconv>

#include "ros2/pairs/pairs.hh"
#include "ros2/pairs/part_pair.hh"

namespace pongsim::ros2 {

namespace {

namespace gz = ros_gz_interfaces;

struct AltimeterPair {
  using Ros = gz::Altimeter;
  using Ignition = ignition::msgs::Altimeter;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    to.vertical_position = from.vertical_position();
    to.vertical_velocity = from.vertical_velocity();
    to.vertical_reference = from.vertical_reference();
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    to.set_vertical_position(from.vertical_position);
    to.set_vertical_velocity(from.vertical_velocity);
    to.set_vertical_reference(from.vertical_reference);
  }
};

struct ContactsPair {
  using Ros = gz::Contacts;
  using Ignition = ignition::msgs::Contacts;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    convertList(from.contact(), to.contacts, frames);
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    to.clear_contact();
    for (const gz::Contact& contact : from.contacts) ros2::convert(contact, *to.add_contact(), frames);
  }
};

/// Fortress stores the received signal strength in the header's data.
struct DataframePair {
  using Ros = gz::Dataframe;
  using Ignition = ignition::msgs::Dataframe;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    to.src_address = from.src_address();
    to.dst_address = from.dst_address();
    to.data.assign(from.data().begin(), from.data().end());
    to.rssi = 0;
    for (const auto& entry : from.header().data()) {
      if (entry.key() != "rssi" || entry.value_size() == 0) continue;
      const std::string& text = entry.value(0);
      std::from_chars(text.data(), text.data() + text.size(), to.rssi);
    }
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    auto* entry = to.mutable_header()->add_data();
    entry->set_key("rssi");
    entry->add_value(std::to_string(from.rssi));
    to.set_src_address(from.src_address);
    to.set_dst_address(from.dst_address);
    to.set_data(from.data.data(), from.data.size());
  }
};

struct EntityWrenchPair {
  using Ros = gz::EntityWrench;
  using Ignition = ignition::msgs::EntityWrench;
  static constexpr bool kMustBeFinite = true;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    ros2::convert(from.entity(), to.entity);
    ros2::convert(from.wrench(), to.wrench);
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    ros2::convert(from.entity, *to.mutable_entity());
    ros2::convert(from.wrench, *to.mutable_wrench());
  }
};

struct Float32ArrayPair {
  using Ros = gz::Float32Array;
  using Ignition = ignition::msgs::Float_V;
  static void convert(const Ignition& from, Ros& to, const Frames&) { copyNumbers(from.data(), to.data); }
  static void convert(const Ros& from, Ignition& to, const Frames&) {
    to.Clear();
    addNumbers(from.data, to.mutable_data());
  }
};

struct GuiCameraPair {
  using Ros = gz::GuiCamera;
  using Ignition = ignition::msgs::GUICamera;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    to.name = from.name();
    to.view_controller = from.view_controller();
    ros2::convert(from.pose(), to.pose);
    ros2::convert(from.track(), to.track, frames);
    to.projection_type = from.projection_type();
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    to.set_name(from.name);
    to.set_view_controller(from.view_controller);
    ros2::convert(from.pose, *to.mutable_pose());
    ros2::convert(from.track, *to.mutable_track(), frames);
    to.set_projection_type(from.projection_type);
  }
};

struct ParamPair {
  using Ros = gz::ParamVec;
  using Ignition = ignition::msgs::Param;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    to.params.clear();
    addParameters(from, "", to.params);
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) { ros2::convert(from, to, frames); }
};

/// To ROS, the names say which parameter it was: "param_0/NAME". From ROS, all go into one, as in ros_gz.
struct ParamsPair {
  using Ros = gz::ParamVec;
  using Ignition = ignition::msgs::Param_V;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    to.params.clear();
    for (int i = 0; i < from.param_size(); ++i) {
      addParameters(from.param(i), "param_" + std::to_string(i) + "/", to.params);
    }
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    to.Clear();
    ros2::convert(from.header, *to.mutable_header(), frames);
    ros2::convert(from, *to.add_param(), frames);
  }
};

/// Both types number the kinds of noise in the same way.
struct SensorNoisePair {
  using Ros = gz::SensorNoise;
  using Ignition = ignition::msgs::SensorNoise;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    to.type = static_cast<std::uint8_t>(from.type());
    to.mean = from.mean();
    to.stddev = from.stddev();
    to.bias_mean = from.bias_mean();
    to.bias_stddev = from.bias_stddev();
    to.precision = from.precision();
    to.dynamic_bias_stddev = from.dynamic_bias_stddev();
    to.dynamic_bias_correlation_time = from.dynamic_bias_correlation_time();
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    to.set_type(Ignition::Type_IsValid(from.type) ? static_cast<Ignition::Type>(from.type) : Ignition::NONE);
    to.set_mean(from.mean);
    to.set_stddev(from.stddev);
    to.set_bias_mean(from.bias_mean);
    to.set_bias_stddev(from.bias_stddev);
    to.set_precision(from.precision);
    to.set_dynamic_bias_stddev(from.dynamic_bias_stddev);
    to.set_dynamic_bias_correlation_time(from.dynamic_bias_correlation_time);
  }
};

struct StringVecPair {
  using Ros = gz::StringVec;
  using Ignition = ignition::msgs::StringMsg_V;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    to.data.assign(from.data().begin(), from.data().end());
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    to.Clear();
    ros2::convert(from.header, *to.mutable_header(), frames);
    for (const std::string& text : from.data) to.add_data(text);
  }
};

struct VideoRecordPair {
  using Ros = gz::VideoRecord;
  using Ignition = ignition::msgs::VideoRecord;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    to.start = from.start();
    to.stop = from.stop();
    to.format = from.format();
    to.save_filename = from.save_filename();
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    to.set_start(from.start);
    to.set_stop(from.stop);
    to.set_format(from.format);
    to.set_save_filename(from.save_filename);
  }
};

}  // namespace

std::vector<Pair> gzPairs() {
  namespace ign = ignition::msgs;
  return {pairOf<AltimeterPair>(Choice::kDefault),
          pairOf<PartPair<gz::Contact, ign::Contact>>(Choice::kDefault),
          pairOf<ContactsPair>(Choice::kDefault),
          pairOf<DataframePair>(Choice::kDefault),
          pairOf<PartPair<gz::Entity, ign::Entity>>(Choice::kDefault),
          pairOf<EntityWrenchPair>(Choice::kDefault),
          pairOf<Float32ArrayPair>(Choice::kDefault),
          pairOf<GuiCameraPair>(Choice::kDefault),
          pairOf<PartPair<gz::JointWrench, ign::JointWrench>>(Choice::kDefault),
          pairOf<PartPair<gz::Light, ign::Light>>(Choice::kDefault),
          pairOf<ParamPair>(Choice::kDefault),
          pairOf<ParamsPair>(Choice::kDefault),
          pairOf<SensorNoisePair>(Choice::kDefault),
          pairOf<StringVecPair>(Choice::kDefault),
          pairOf<PartPair<gz::TrackVisual, ign::TrackVisual>>(Choice::kDefault),
          pairOf<VideoRecordPair>(Choice::kDefault),
          pairOf<PartPair<gz::WorldControl, ign::WorldControl>>(Choice::kDefault)};
}

}  // namespace pongsim::ros2
