#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ros2/types/builtin_interfaces.hh"
#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/rcl_interfaces.hh"
#include "ros2/types/std_msgs.hh"

namespace pongsim::ros2::ros_gz_interfaces {

struct Altimeter {
  static constexpr const char* kName = "ros_gz_interfaces/msg/Altimeter";
  std_msgs::Header header;
  double vertical_position = 0;
  double vertical_velocity = 0;
  double vertical_reference = 0;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("vertical_position", self.vertical_position);
    field("vertical_velocity", self.vertical_velocity);
    field("vertical_reference", self.vertical_reference);
  }
  bool operator==(const Altimeter&) const = default;
};

struct Entity {
  static constexpr const char* kName = "ros_gz_interfaces/msg/Entity";
  static constexpr std::uint8_t kNone = 0;
  static constexpr std::uint8_t kLight = 1;
  static constexpr std::uint8_t kModel = 2;
  static constexpr std::uint8_t kLink = 3;
  static constexpr std::uint8_t kVisual = 4;
  static constexpr std::uint8_t kCollision = 5;
  static constexpr std::uint8_t kSensor = 6;
  static constexpr std::uint8_t kJoint = 7;
  std::uint64_t id = 0;
  std::string name;
  std::uint8_t type = 0;
  static void visit(auto& self, auto&& field) {
    field("id", self.id);
    field("name", self.name);
    field("type", self.type);
  }
  bool operator==(const Entity&) const = default;
};

struct JointWrench {
  static constexpr const char* kName = "ros_gz_interfaces/msg/JointWrench";
  std_msgs::Header header;
  std_msgs::String body_1_name;
  std_msgs::UInt32 body_1_id;
  std_msgs::String body_2_name;
  std_msgs::UInt32 body_2_id;
  geometry_msgs::Wrench body_1_wrench;
  geometry_msgs::Wrench body_2_wrench;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("body_1_name", self.body_1_name);
    field("body_1_id", self.body_1_id);
    field("body_2_name", self.body_2_name);
    field("body_2_id", self.body_2_id);
    field("body_1_wrench", self.body_1_wrench);
    field("body_2_wrench", self.body_2_wrench);
  }
  bool operator==(const JointWrench&) const = default;
};

struct Contact {
  static constexpr const char* kName = "ros_gz_interfaces/msg/Contact";
  Entity collision1;
  Entity collision2;
  std::vector<geometry_msgs::Vector3> positions;
  std::vector<geometry_msgs::Vector3> normals;
  std::vector<double> depths;
  std::vector<JointWrench> wrenches;
  static void visit(auto& self, auto&& field) {
    field("collision1", self.collision1);
    field("collision2", self.collision2);
    field("positions", self.positions);
    field("normals", self.normals);
    field("depths", self.depths);
    field("wrenches", self.wrenches);
  }
  bool operator==(const Contact&) const = default;
};

struct Contacts {
  static constexpr const char* kName = "ros_gz_interfaces/msg/Contacts";
  std_msgs::Header header;
  std::vector<Contact> contacts;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("contacts", self.contacts);
  }
  bool operator==(const Contacts&) const = default;
};

struct Dataframe {
  static constexpr const char* kName = "ros_gz_interfaces/msg/Dataframe";
  std_msgs::Header header;
  std::string src_address;
  std::string dst_address;
  std::vector<std::uint8_t> data;
  double rssi = 0;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("src_address", self.src_address);
    field("dst_address", self.dst_address);
    field("data", self.data);
    field("rssi", self.rssi);
  }
  bool operator==(const Dataframe&) const = default;
};

struct EntityFactory {
  static constexpr const char* kName = "ros_gz_interfaces/msg/EntityFactory";
  std::string name;
  bool allow_renaming = false;
  std::string sdf;
  std::string sdf_filename;
  std::string clone_name;
  geometry_msgs::Pose pose;
  std::string relative_to = "world";
  static void visit(auto& self, auto&& field) {
    field("name", self.name);
    field("allow_renaming", self.allow_renaming);
    field("sdf", self.sdf);
    field("sdf_filename", self.sdf_filename);
    field("clone_name", self.clone_name);
    field("pose", self.pose);
    field("relative_to", self.relative_to);
  }
  bool operator==(const EntityFactory&) const = default;
};

struct EntityWrench {
  static constexpr const char* kName = "ros_gz_interfaces/msg/EntityWrench";
  std_msgs::Header header;
  Entity entity;
  geometry_msgs::Wrench wrench;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("entity", self.entity);
    field("wrench", self.wrench);
  }
  bool operator==(const EntityWrench&) const = default;
};

struct Float32Array {
  static constexpr const char* kName = "ros_gz_interfaces/msg/Float32Array";
  std::vector<float> data;
  static void visit(auto& self, auto&& field) { field("data", self.data); }
  bool operator==(const Float32Array&) const = default;
};

struct TrackVisual {
  static constexpr const char* kName = "ros_gz_interfaces/msg/TrackVisual";
  std_msgs::Header header;
  std::string name;
  std::uint32_t id = 0;
  bool inherit_orientation = false;
  double min_dist = 0;
  double max_dist = 0;
  bool is_static = false;
  bool use_model_frame = false;
  geometry_msgs::Vector3 xyz;
  bool inherit_yaw = false;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("name", self.name);
    field("id", self.id);
    field("inherit_orientation", self.inherit_orientation);
    field("min_dist", self.min_dist);
    field("max_dist", self.max_dist);
    field("is_static", self.is_static);
    field("use_model_frame", self.use_model_frame);
    field("xyz", self.xyz);
    field("inherit_yaw", self.inherit_yaw);
  }
  bool operator==(const TrackVisual&) const = default;
};

struct GuiCamera {
  static constexpr const char* kName = "ros_gz_interfaces/msg/GuiCamera";
  std_msgs::Header header;
  std::string name;
  std::string view_controller;
  geometry_msgs::Pose pose;
  TrackVisual track;
  std::string projection_type;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("name", self.name);
    field("view_controller", self.view_controller);
    field("pose", self.pose);
    field("track", self.track);
    field("projection_type", self.projection_type);
  }
  bool operator==(const GuiCamera&) const = default;
};

struct Light {
  static constexpr const char* kName = "ros_gz_interfaces/msg/Light";
  static constexpr std::uint8_t kPoint = 0;
  static constexpr std::uint8_t kSpot = 1;
  static constexpr std::uint8_t kDirectional = 2;
  std_msgs::Header header;
  std::string name;
  std::uint8_t type = 0;
  geometry_msgs::Pose pose;
  std_msgs::ColorRGBA diffuse;
  std_msgs::ColorRGBA specular;
  float attenuation_constant = 0;
  float attenuation_linear = 0;
  float attenuation_quadratic = 0;
  geometry_msgs::Vector3 direction;
  float range = 0;
  bool cast_shadows = false;
  float spot_inner_angle = 0;
  float spot_outer_angle = 0;
  float spot_falloff = 0;
  std::uint32_t id = 0;
  std::uint32_t parent_id = 0;
  float intensity = 0;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("name", self.name);
    field("type", self.type);
    field("pose", self.pose);
    field("diffuse", self.diffuse);
    field("specular", self.specular);
    field("attenuation_constant", self.attenuation_constant);
    field("attenuation_linear", self.attenuation_linear);
    field("attenuation_quadratic", self.attenuation_quadratic);
    field("direction", self.direction);
    field("range", self.range);
    field("cast_shadows", self.cast_shadows);
    field("spot_inner_angle", self.spot_inner_angle);
    field("spot_outer_angle", self.spot_outer_angle);
    field("spot_falloff", self.spot_falloff);
    field("id", self.id);
    field("parent_id", self.parent_id);
    field("intensity", self.intensity);
  }
  bool operator==(const Light&) const = default;
};

struct ParamVec {
  static constexpr const char* kName = "ros_gz_interfaces/msg/ParamVec";
  std_msgs::Header header;
  std::vector<rcl_interfaces::Parameter> params;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("params", self.params);
  }
  bool operator==(const ParamVec&) const = default;
};

struct SensorNoise {
  static constexpr const char* kName = "ros_gz_interfaces/msg/SensorNoise";
  static constexpr std::uint8_t kNone = 0;
  static constexpr std::uint8_t kGaussian = 2;
  static constexpr std::uint8_t kGaussianQuantized = 3;
  std_msgs::Header header;
  std::uint8_t type = 0;
  double mean = 0;
  double stddev = 0;
  double bias_mean = 0;
  double bias_stddev = 0;
  double precision = 0;
  double dynamic_bias_stddev = 0;
  double dynamic_bias_correlation_time = 0;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("type", self.type);
    field("mean", self.mean);
    field("stddev", self.stddev);
    field("bias_mean", self.bias_mean);
    field("bias_stddev", self.bias_stddev);
    field("precision", self.precision);
    field("dynamic_bias_stddev", self.dynamic_bias_stddev);
    field("dynamic_bias_correlation_time", self.dynamic_bias_correlation_time);
  }
  bool operator==(const SensorNoise&) const = default;
};

struct StringVec {
  static constexpr const char* kName = "ros_gz_interfaces/msg/StringVec";
  std_msgs::Header header;
  std::vector<std::string> data;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("data", self.data);
  }
  bool operator==(const StringVec&) const = default;
};

struct VideoRecord {
  static constexpr const char* kName = "ros_gz_interfaces/msg/VideoRecord";
  std_msgs::Header header;
  bool start = false;
  bool stop = false;
  std::string format;
  std::string save_filename;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("start", self.start);
    field("stop", self.stop);
    field("format", self.format);
    field("save_filename", self.save_filename);
  }
  bool operator==(const VideoRecord&) const = default;
};

struct WorldReset {
  static constexpr const char* kName = "ros_gz_interfaces/msg/WorldReset";
  bool all = false;
  bool time_only = false;
  bool model_only = false;
  static void visit(auto& self, auto&& field) {
    field("all", self.all);
    field("time_only", self.time_only);
    field("model_only", self.model_only);
  }
  bool operator==(const WorldReset&) const = default;
};

struct WorldControl {
  static constexpr const char* kName = "ros_gz_interfaces/msg/WorldControl";
  bool pause = false;
  bool step = false;
  std::uint32_t multi_step = 0;
  WorldReset reset;
  std::uint32_t seed = 0;
  builtin_interfaces::Time run_to_sim_time;
  static void visit(auto& self, auto&& field) {
    field("pause", self.pause);
    field("step", self.step);
    field("multi_step", self.multi_step);
    field("reset", self.reset);
    field("seed", self.seed);
    field("run_to_sim_time", self.run_to_sim_time);
  }
  bool operator==(const WorldControl&) const = default;
};

namespace srv {

struct ControlWorld {
  static constexpr const char* kName = "ros_gz_interfaces/srv/ControlWorld";
  struct Request {
    static constexpr const char* kName = "ros_gz_interfaces/srv/ControlWorld_Request";
    ros_gz_interfaces::WorldControl world_control;
    static void visit(auto& self, auto&& field) { field("world_control", self.world_control); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "ros_gz_interfaces/srv/ControlWorld_Response";
    bool success = false;
    static void visit(auto& self, auto&& field) { field("success", self.success); }
    bool operator==(const Response&) const = default;
  };
};

struct DeleteEntity {
  static constexpr const char* kName = "ros_gz_interfaces/srv/DeleteEntity";
  struct Request {
    static constexpr const char* kName = "ros_gz_interfaces/srv/DeleteEntity_Request";
    ros_gz_interfaces::Entity entity;
    static void visit(auto& self, auto&& field) { field("entity", self.entity); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "ros_gz_interfaces/srv/DeleteEntity_Response";
    bool success = false;
    static void visit(auto& self, auto&& field) { field("success", self.success); }
    bool operator==(const Response&) const = default;
  };
};

struct SetEntityPose {
  static constexpr const char* kName = "ros_gz_interfaces/srv/SetEntityPose";
  struct Request {
    static constexpr const char* kName = "ros_gz_interfaces/srv/SetEntityPose_Request";
    ros_gz_interfaces::Entity entity;
    geometry_msgs::Pose pose;
    static void visit(auto& self, auto&& field) {
      field("entity", self.entity);
      field("pose", self.pose);
    }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "ros_gz_interfaces/srv/SetEntityPose_Response";
    bool success = false;
    static void visit(auto& self, auto&& field) { field("success", self.success); }
    bool operator==(const Response&) const = default;
  };
};

struct SpawnEntity {
  static constexpr const char* kName = "ros_gz_interfaces/srv/SpawnEntity";
  struct Request {
    static constexpr const char* kName = "ros_gz_interfaces/srv/SpawnEntity_Request";
    ros_gz_interfaces::EntityFactory entity_factory;
    static void visit(auto& self, auto&& field) { field("entity_factory", self.entity_factory); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "ros_gz_interfaces/srv/SpawnEntity_Response";
    bool success = false;
    static void visit(auto& self, auto&& field) { field("success", self.success); }
    bool operator==(const Response&) const = default;
  };
};

}  // namespace srv

}  // namespace pongsim::ros2::ros_gz_interfaces
