// Tests every pair in both directions: a ROS message with all fields set is converted to the simulation's type and
// back.
#include "ros2/pairs/pairs.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/fluid_pressure.pb.h>
#include <ignition/msgs/imu.pb.h>
#include <ignition/msgs/magnetometer.pb.h>
#include <ignition/msgs/model.pb.h>
#include <ignition/msgs/navsat.pb.h>

#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "ros2/types/actuator_msgs.hh"
#include "ros2/types/cdr.hh"
#include "ros2/types/gps_msgs.hh"
#include "ros2/types/nav_msgs.hh"
#include "ros2/types/ros_gz_interfaces.hh"
#include "ros2/types/rosgraph_msgs.hh"
#include "ros2/types/sensor_msgs.hh"
#include "ros2/types/tf2_msgs.hh"
#include "ros2/types/trajectory_msgs.hh"
#include "ros2/types/vision_msgs.hh"

namespace pongsim::ros2 {
namespace {

/// Gives each field a value of its own, which both a float and a double can represent.
class Filler {
 public:
  template <class Value>
  void fill(Value& value) {
    if constexpr (std::is_same_v<Value, bool>) {
      value = true;
    } else if constexpr (std::is_same_v<Value, std::byte>) {
      value = static_cast<std::byte>(next());
    } else if constexpr (std::is_floating_point_v<Value>) {
      value = static_cast<Value>(next()) + static_cast<Value>(0.25);
    } else if constexpr (std::is_integral_v<Value>) {
      value = static_cast<Value>(next());
    } else if constexpr (Structure<Value>) {
      visitFields(value, [this](const char*, auto& field) { fill(field); });
    } else if constexpr (Text<Value>) {
      value = "text" + std::to_string(next());
    } else if constexpr (kIsArray<Value>) {
      for (auto& element : value) fill(element);
    } else if constexpr (std::is_same_v<Value, std::vector<bool>>) {
      value = {true, false};
    } else {
      value.resize(2);
      for (auto& element : value) fill(element);
    }
  }

 private:
  int next() { return ++count_ % 100; }
  int count_ = 0;
};

/// The names of the fields that differ: "header.frame_id".
template <class Value>
void differences(const Value& a, const Value& b, const std::string& name, std::set<std::string>& found) {
  if constexpr (Structure<Value>) {
    // its dummy field on the wire does not exist in memory
    if (isEmpty<Value>()) return;
    Value copy = b;
    std::vector<void*> others;
    visitFields(copy, [&](const char*, auto& field) { others.push_back(&field); });
    std::size_t i = 0;
    visitFields(a, [&]<class Field>(const char* field, const Field& value) {
      differences(value, *static_cast<const Field*>(others[i++]), name.empty() ? field : name + "." + field, found);
    });
  } else if constexpr (List<Value> && !std::is_same_v<Value, std::vector<bool>>) {
    if (a.size() != b.size()) {
      found.insert(name);
      return;
    }
    for (std::size_t i = 0; i < a.size(); ++i) differences(a[i], b[i], name, found);
  } else {
    if (a != b) found.insert(name);
  }
}

/// @return The message that a ROS node receives.
template <class Ros>
Ros heardBy(const Pair& pair, const Message& message, const Frames& frames = {}) {
  std::vector<std::byte> payload;
  pair.toRos(frames)->convert(message, nullptr, [&payload](std::size_t size, const Fill& fill) {
    payload.resize(size);
    fill(payload);
  });
  Ros heard;
  EXPECT_FALSE(readCdr(payload, heard).has_value());
  return heard;
}

template <class Ros>
using Adjust = std::function<void(Ros&)>;

/// @param lost Fields that the simulation's type lacks.
template <class Ros>
void goesThereAndBack(const std::string& ignition, const std::set<std::string>& lost = {},
                      const Adjust<Ros>& adjust = {}) {
  SCOPED_TRACE(nameOf<Ros>() + " | " + ignition);
  const Pair* pair = findPair(nameOf<Ros>(), "ignition.msgs." + ignition);
  ASSERT_NE(pair, nullptr);
  const std::unique_ptr<ToIgnition> toIgnition = pair->toIgnition({});
  const std::unique_ptr<ToRos> toRos = pair->toRos({});
  // the second time, to find leftovers of the first
  for (int i = 0; i < 2; ++i) {
    Ros sent;
    Filler().fill(sent);
    if (adjust) adjust(sent);
    std::string error;
    const Message* message = toIgnition->convert(toCdr(sent), error);
    ASSERT_NE(message, nullptr) << error;
    std::vector<std::byte> payload;
    toRos->convert(*message, nullptr, [&payload](std::size_t size, const Fill& fill) {
      payload.resize(size);
      fill(payload);
    });
    Ros heard;
    ASSERT_FALSE(readCdr(payload, heard).has_value());
    std::set<std::string> found;
    differences(sent, heard, "", found);
    EXPECT_EQ(found, lost);
  }
}

TEST(Pairs, OfPlainValuesGoThereAndBack) {
  goesThereAndBack<builtin_interfaces::Time>("Time");
  goesThereAndBack<rosgraph_msgs::Clock>("Clock");
  goesThereAndBack<std_msgs::Bool>("Boolean");
  goesThereAndBack<std_msgs::ColorRGBA>("Color");
  goesThereAndBack<std_msgs::Empty>("Empty");
  goesThereAndBack<std_msgs::Float32>("Float");
  goesThereAndBack<std_msgs::Float64>("Double");
  goesThereAndBack<std_msgs::Header>("Header");
  goesThereAndBack<std_msgs::Int32>("Int32");
  goesThereAndBack<std_msgs::UInt32>("UInt32");
  goesThereAndBack<std_msgs::String>("StringMsg");
}

TEST(Pairs, OfParametersGoThereAndBack) {
  using Value = rcl_interfaces::ParameterValue;
  const std::set<std::string> lists = {"byte_array_value", "bool_array_value", "integer_array_value",
                                       "double_array_value", "string_array_value"};
  const std::vector<std::string> singles = {"bool_value", "integer_value", "double_value", "string_value"};
  for (std::size_t i = 0; i < singles.size(); ++i) {
    std::set<std::string> lost = lists;
    lost.insert(singles.begin(), singles.end());
    lost.erase(singles[i]);
    goesThereAndBack<Value>("Any", lost, [i](Value& value) { value.type = static_cast<std::uint8_t>(i + 1); });
  }
}

TEST(Pairs, OfGeometryGoThereAndBack) {
  using namespace geometry_msgs;
  goesThereAndBack<Vector3>("Vector3d");
  goesThereAndBack<Point>("Vector3d");
  goesThereAndBack<geometry_msgs::Quaternion>("Quaternion");
  goesThereAndBack<geometry_msgs::Pose>("Pose");
  goesThereAndBack<PoseArray>("Pose_V");
  goesThereAndBack<PoseStamped>("Pose");
  goesThereAndBack<PoseWithCovariance>("PoseWithCovariance");
  goesThereAndBack<Transform>("Pose");
  goesThereAndBack<TransformStamped>("Pose");
  goesThereAndBack<Twist>("Twist");
  goesThereAndBack<TwistStamped>("Twist");
  goesThereAndBack<TwistWithCovariance>("TwistWithCovariance");
  goesThereAndBack<TwistWithCovarianceStamped>("TwistWithCovariance");
  goesThereAndBack<geometry_msgs::Wrench>("Wrench");
  goesThereAndBack<WrenchStamped>("Wrench");
}

TEST(Pairs, OfMotionGoThereAndBack) {
  goesThereAndBack<nav_msgs::Odometry>("Odometry", {"pose.covariance", "twist.covariance"});
  goesThereAndBack<nav_msgs::Odometry>("OdometryWithCovariance");
  goesThereAndBack<tf2_msgs::TFMessage>("Pose_V");
  goesThereAndBack<trajectory_msgs::JointTrajectory>("JointTrajectory");
  goesThereAndBack<actuator_msgs::Actuators>("Actuators");
  goesThereAndBack<sensor_msgs::JointState>("Model");
}

TEST(Pairs, OfJointStatesHaveNoNumberForWhatTheyDoNotSay) {
  sensor_msgs::JointState state;
  state.name = {"a", "b"};
  state.position = {1};
  std::vector<std::byte> payload(cdrSize(state));
  writeCdr(state, payload);
  const std::unique_ptr<ToIgnition> toIgnition =
      findPair("sensor_msgs/msg/JointState", "ignition.msgs.Model")->toIgnition({});
  std::string error;
  const auto* message = static_cast<const ignition::msgs::Model*>(toIgnition->convert(payload, error));
  ASSERT_NE(message, nullptr) << error;
  ASSERT_EQ(message->joint_size(), 2);
  EXPECT_EQ(message->joint(0).axis1().position(), 1);
  EXPECT_TRUE(std::isnan(message->joint(0).axis1().velocity()));
  EXPECT_TRUE(std::isnan(message->joint(1).axis1().position()));
}

TEST(Pairs, OfSensorsGoThereAndBack) {
  using namespace sensor_msgs;
  goesThereAndBack<LaserScan>("LaserScan", {"time_increment", "scan_time"});
  goesThereAndBack<Imu>("IMU",
                        {"orientation_covariance", "angular_velocity_covariance", "linear_acceleration_covariance"});
  goesThereAndBack<MagneticField>("Magnetometer", {"magnetic_field_covariance"});
  goesThereAndBack<FluidPressure>("FluidPressure");
  goesThereAndBack<NavSatFix>("NavSat",
                              {"status.status", "status.service", "position_covariance", "position_covariance_type"});
  goesThereAndBack<BatteryState>(
      "BatteryState",
      {"temperature", "design_capacity", "power_supply_health", "power_supply_technology", "cell_voltage",
       "cell_temperature", "location", "serial_number"},
      [](BatteryState& state) { state.power_supply_status = BatteryState::kPowerSupplyStatusFull; });
  goesThereAndBack<Joy>("Joy");
}

TEST(Pairs, OfSensorsTellTheVariancesOfTheirNoise) {
  const Frames frames{.variances = {{1, 4, 9}, {0.1, 0.2, 0.3}}};
  ignition::msgs::IMU reading;
  const Pair& imu = *findPair("sensor_msgs/msg/Imu", "ignition.msgs.IMU");
  const auto heard = heardBy<sensor_msgs::Imu>(imu, reading, frames);
  EXPECT_EQ(heard.angular_velocity_covariance, (std::array<double, 9>{1, 0, 0, 0, 4, 0, 0, 0, 9}));
  EXPECT_EQ(heard.linear_acceleration_covariance, (std::array<double, 9>{0.1, 0, 0, 0, 0.2, 0, 0, 0, 0.3}));
  // it has no orientation
  EXPECT_EQ(heard.orientation_covariance[0], -1);
  reading.mutable_orientation()->set_w(1);
  EXPECT_EQ(heardBy<sensor_msgs::Imu>(imu, reading, frames).orientation_covariance[0], 0);

  const auto field = heardBy<sensor_msgs::MagneticField>(
      *findPair("sensor_msgs/msg/MagneticField", "ignition.msgs.Magnetometer"), ignition::msgs::Magnetometer(), frames);
  EXPECT_EQ(field.magnetic_field_covariance, heard.angular_velocity_covariance);
  const auto pressure =
      heardBy<sensor_msgs::FluidPressure>(*findPair("sensor_msgs/msg/FluidPressure", "ignition.msgs.FluidPressure"),
                                          ignition::msgs::FluidPressure(), frames);
  EXPECT_EQ(pressure.variance, 1);
}

TEST(Pairs, OfNavSatGiveTheCovarianceInMetres) {
  using Fix = sensor_msgs::NavSatFix;
  ignition::msgs::NavSat reading;
  reading.set_latitude_deg(60);
  const Pair& pair = *findPair("sensor_msgs/msg/NavSatFix", "ignition.msgs.NavSat");
  EXPECT_EQ(heardBy<Fix>(pair, reading).position_covariance_type, Fix::kCovarianceTypeUnknown);
  // 1e-5 degrees are 1.113 m of a meridian, half of that of the parallel of 60 degrees
  const Fix fix = heardBy<Fix>(pair, reading, {.variances = {{1e-10, 1e-10, 9}, {}}});
  EXPECT_EQ(fix.position_covariance_type, Fix::kCovarianceTypeDiagonalKnown);
  EXPECT_NEAR(std::sqrt(fix.position_covariance[0]), 0.557, 0.001);
  EXPECT_NEAR(std::sqrt(fix.position_covariance[4]), 1.113, 0.001);
  EXPECT_EQ(fix.position_covariance[8], 9);
}

TEST(Pairs, OfGpsFixGoThereAndBackByItsVelocity) {
  gps_msgs::GPSFix sent;
  sent.latitude = 47.5;
  sent.longitude = -122.25;
  sent.altitude = 12;
  sent.speed = 2;
  sent.track = 0.5;
  sent.climb = -1;
  const Pair* pair = findPair("gps_msgs/msg/GPSFix", "ignition.msgs.NavSat");
  ASSERT_NE(pair, nullptr);
  std::string error;
  const std::unique_ptr<ToIgnition> toIgnition = pair->toIgnition({});
  const Message* message = toIgnition->convert(toCdr(sent), error);
  ASSERT_NE(message, nullptr) << error;
  const gps_msgs::GPSFix heard = heardBy<gps_msgs::GPSFix>(*pair, *message);
  EXPECT_EQ(heard.latitude, 47.5);
  EXPECT_EQ(heard.longitude, -122.25);
  EXPECT_EQ(heard.altitude, 12);
  EXPECT_DOUBLE_EQ(heard.speed, 2);
  EXPECT_DOUBLE_EQ(heard.track, 0.5);
  EXPECT_EQ(heard.climb, -1);
}

TEST(Pairs, OfImagesAndCloudsGoThereAndBack) {
  using namespace sensor_msgs;
  for (const char* encoding : {"mono8", "mono16", "rgb8", "rgba8", "bgra8", "rgb16", "bgr8", "bgr16", "32FC1"}) {
    goesThereAndBack<Image>("Image", {}, [encoding](Image& image) {
      const std::string name = encoding;
      image.encoding = name;
      image.is_bigendian = 0;
      image.width = 2;
      const bool isWide = name.ends_with("16");
      const std::uint32_t channels = name.starts_with("mono") || name == "32FC1" ? 1 : name.find('a') < 4 ? 4 : 3;
      image.step = 2 * channels * (name == "32FC1" ? 4 : isWide ? 2 : 1);
    });
  }
  goesThereAndBack<PointCloud2>("PointCloudPacked", {}, [](PointCloud2& cloud) {
    cloud.fields[0].datatype = PointField::kInt8;
    cloud.fields[1].datatype = PointField::kFloat64;
  });
  for (const char* model : {"plumb_bob", "rational_polynomial", "equidistant"}) {
    goesThereAndBack<CameraInfo>(
        "CameraInfo",
        {"binning_x", "binning_y", "roi.x_offset", "roi.y_offset", "roi.height", "roi.width", "roi.do_rectify"},
        [model](CameraInfo& info) { info.distortion_model = model; });
  }
}

TEST(Pairs, OfRosGzGoThereAndBack) {
  using namespace ros_gz_interfaces;
  const Adjust<Contact> knownTypes = [](Contact& contact) {
    contact.collision1.type = Entity::kCollision;
    contact.collision2.type = Entity::kLink;
  };
  const Adjust<ParamVec> whole = [](ParamVec& list) {
    // they are sorted by name
    list.params[0].name = "a";
    list.params[1].name = "b";
    for (rcl_interfaces::Parameter& parameter : list.params) {
      parameter.value = {};
      parameter.value.type = rcl_interfaces::ParameterType::kParameterInteger;
      parameter.value.integer_value = 7;
    }
  };
  goesThereAndBack<Altimeter>("Altimeter");
  goesThereAndBack<Contact>("Contact", {}, knownTypes);
  goesThereAndBack<Contacts>("Contacts", {}, [&](Contacts& contacts) {
    for (Contact& contact : contacts.contacts) knownTypes(contact);
  });
  goesThereAndBack<Dataframe>("Dataframe");
  goesThereAndBack<Entity>("Entity", {}, [](Entity& entity) { entity.type = Entity::kJoint; });
  goesThereAndBack<EntityWrench>("EntityWrench", {}, [](EntityWrench& wrench) { wrench.entity.type = Entity::kModel; });
  goesThereAndBack<Float32Array>("Float_V");
  goesThereAndBack<GuiCamera>("GUICamera");
  goesThereAndBack<JointWrench>("JointWrench");
  goesThereAndBack<Light>("Light", {}, [](Light& light) { light.type = Light::kDirectional; });
  goesThereAndBack<ParamVec>("Param", {}, whole);
  goesThereAndBack<ParamVec>("Param_V", {"params.name"}, whole);
  goesThereAndBack<SensorNoise>("SensorNoise", {},
                                [](SensorNoise& noise) { noise.type = SensorNoise::kGaussianQuantized; });
  goesThereAndBack<StringVec>("StringMsg_V");
  goesThereAndBack<TrackVisual>("TrackVisual");
  goesThereAndBack<VideoRecord>("VideoRecord");
  goesThereAndBack<WorldControl>("WorldControl");
}

TEST(Pairs, OfVisionGoThereAndBack) {
  using namespace vision_msgs;
  const auto adjust = [](auto& detection) {
    detection.results.resize(1);
    detection.results.front() = {};
    detection.results.front().hypothesis = {"7", 1};
    detection.id.clear();
  };
  goesThereAndBack<Detection2D>("AnnotatedAxisAligned2DBox", {"bbox.center.theta"}, adjust);
  goesThereAndBack<Detection2DArray>("AnnotatedAxisAligned2DBox_V", {"detections.bbox.center.theta"},
                                     [&](Detection2DArray& all) {
                                       for (Detection2D& each : all.detections) adjust(each);
                                     });
  goesThereAndBack<Detection3D>("AnnotatedOriented3DBox", {}, adjust);
  goesThereAndBack<Detection3DArray>("AnnotatedOriented3DBox_V", {}, [&](Detection3DArray& all) {
    for (Detection3D& each : all.detections) adjust(each);
  });
}

TEST(Pairs, HaveOneDefaultForEachTypeOfTheSimulation) {
  std::set<std::string> types, defaults;
  for (const Pair& pair : allPairs()) {
    types.insert(pair.ignition);
    if (pair.isDefault) {
      EXPECT_TRUE(defaults.insert(pair.ignition).second) << pair.ignition;
    }
    EXPECT_TRUE(messageTypeName(pair.ignition).has_value()) << pair.ignition;
  }
  EXPECT_EQ(types, defaults);
}

TEST(Pairs, RefuseCommandsThatAreNotFinite) {
  geometry_msgs::Twist twist;
  twist.linear.x = std::numeric_limits<double>::quiet_NaN();
  std::string error;
  EXPECT_EQ(findPair("geometry_msgs/msg/Twist", "ignition.msgs.Twist")->toIgnition({})->convert(toCdr(twist), error),
            nullptr);
  EXPECT_NE(error.find("not finite"), std::string::npos) << error;
}

TEST(Pairs, NamePosesOfAWorldAndStampThem) {
  const Pair* pair = findPair("tf2_msgs/msg/TFMessage", "ignition.msgs.Pose_V");
  const MessagePointer poses = newMessage("ignition.msgs.Pose_V");
  ASSERT_FALSE(parseMessage("header: {stamp: {sec: 7}}, pose: {name: 'car'}, pose: {name: 'wheel', header: {stamp: "
                            "{sec: 8}, data: {key: 'child_frame_id', value: 'car::wheel'}}}",
                            *poses)
                   .has_value());
  const auto heard = heardBy<tf2_msgs::TFMessage>(*pair, *poses);
  ASSERT_EQ(heard.transforms.size(), 2U);
  EXPECT_EQ(heard.transforms[0].child_frame_id, "car");
  EXPECT_EQ(heard.transforms[0].header.stamp.sec, 7);
  EXPECT_EQ(heard.transforms[1].child_frame_id, "car/wheel");
  EXPECT_EQ(heard.transforms[1].header.stamp.sec, 8);
}

TEST(Pairs, GiveFramesOfRosSlashesAndThePrefix) {
  const Pair* pair = findPair("sensor_msgs/msg/LaserScan", "ignition.msgs.LaserScan");
  const MessagePointer scan = newMessage("ignition.msgs.LaserScan");
  ASSERT_FALSE(parseMessage("frame: 'car::chassis::lidar', count: 2, ranges: [1, 2]", *scan).has_value());
  Frames frames;
  frames.prefix = "one/";
  const auto heard = heardBy<sensor_msgs::LaserScan>(*pair, *scan, frames);
  EXPECT_EQ(heard.header.frame_id, "one/car/chassis/lidar");
  EXPECT_EQ(heard.ranges, (std::vector<float>{1, 2}));
}

}  // namespace
}  // namespace pongsim::ros2
