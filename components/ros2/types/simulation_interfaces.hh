#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/std_msgs.hh"

namespace pongsim::ros2::simulation_interfaces {

struct Bounds {
  static constexpr const char* kName = "simulation_interfaces/msg/Bounds";
  static constexpr std::uint8_t kTypeEmpty = 0;
  static constexpr std::uint8_t kTypeBox = 1;
  static constexpr std::uint8_t kTypeConvexHull = 2;
  static constexpr std::uint8_t kTypeSphere = 3;
  std::uint8_t type = 0;
  std::vector<geometry_msgs::Vector3> points;
  static void visit(auto& self, auto&& field) {
    field("type", self.type);
    field("points", self.points);
  }
  bool operator==(const Bounds&) const = default;
};

struct EntityCategory {
  static constexpr const char* kName = "simulation_interfaces/msg/EntityCategory";
  static constexpr std::uint8_t kCategoryObject = 0;
  static constexpr std::uint8_t kCategoryRobot = 1;
  static constexpr std::uint8_t kCategoryHuman = 2;
  static constexpr std::uint8_t kCategoryDynamicObject = 4;
  static constexpr std::uint8_t kCategoryStaticObject = 5;
  std::uint8_t category = 0;
  static void visit(auto& self, auto&& field) { field("category", self.category); }
  bool operator==(const EntityCategory&) const = default;
};

struct TagsFilter {
  static constexpr const char* kName = "simulation_interfaces/msg/TagsFilter";
  static constexpr std::uint8_t kFilterModeAny = 0;
  static constexpr std::uint8_t kFilterModeAll = 1;
  std::vector<std::string> tags;
  std::uint8_t filter_mode = 0;
  static void visit(auto& self, auto&& field) {
    field("tags", self.tags);
    field("filter_mode", self.filter_mode);
  }
  bool operator==(const TagsFilter&) const = default;
};

struct EntityFilters {
  static constexpr const char* kName = "simulation_interfaces/msg/EntityFilters";
  std::string filter;
  std::vector<EntityCategory> categories;
  TagsFilter tags;
  Bounds bounds;
  static void visit(auto& self, auto&& field) {
    field("filter", self.filter);
    field("categories", self.categories);
    field("tags", self.tags);
    field("bounds", self.bounds);
  }
  bool operator==(const EntityFilters&) const = default;
};

struct EntityInfo {
  static constexpr const char* kName = "simulation_interfaces/msg/EntityInfo";
  EntityCategory category;
  std::string description;
  std::vector<std::string> tags;
  static void visit(auto& self, auto&& field) {
    field("category", self.category);
    field("description", self.description);
    field("tags", self.tags);
  }
  bool operator==(const EntityInfo&) const = default;
};

struct EntityState {
  static constexpr const char* kName = "simulation_interfaces/msg/EntityState";
  std_msgs::Header header;
  geometry_msgs::Pose pose;
  geometry_msgs::Twist twist;
  geometry_msgs::Accel acceleration;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("pose", self.pose);
    field("twist", self.twist);
    field("acceleration", self.acceleration);
  }
  bool operator==(const EntityState&) const = default;
};

struct NamedPose {
  static constexpr const char* kName = "simulation_interfaces/msg/NamedPose";
  std::string name;
  std::string description;
  std::vector<std::string> tags;
  geometry_msgs::Pose pose;
  static void visit(auto& self, auto&& field) {
    field("name", self.name);
    field("description", self.description);
    field("tags", self.tags);
    field("pose", self.pose);
  }
  bool operator==(const NamedPose&) const = default;
};

struct Resource {
  static constexpr const char* kName = "simulation_interfaces/msg/Resource";
  std::string uri;
  std::string resource_string;
  static void visit(auto& self, auto&& field) {
    field("uri", self.uri);
    field("resource_string", self.resource_string);
  }
  bool operator==(const Resource&) const = default;
};

struct Result {
  static constexpr const char* kName = "simulation_interfaces/msg/Result";
  static constexpr std::uint8_t kResultFeatureUnsupported = 0;
  static constexpr std::uint8_t kResultOk = 1;
  static constexpr std::uint8_t kResultNotFound = 2;
  static constexpr std::uint8_t kResultIncorrectState = 3;
  static constexpr std::uint8_t kResultOperationFailed = 4;
  std::uint8_t result = 0;
  std::string error_message;
  static void visit(auto& self, auto&& field) {
    field("result", self.result);
    field("error_message", self.error_message);
  }
  bool operator==(const Result&) const = default;
};

struct SimulationState {
  static constexpr const char* kName = "simulation_interfaces/msg/SimulationState";
  static constexpr std::uint8_t kStateStopped = 0;
  static constexpr std::uint8_t kStatePlaying = 1;
  static constexpr std::uint8_t kStatePaused = 2;
  static constexpr std::uint8_t kStateQuitting = 3;
  static constexpr std::uint8_t kStateNoWorld = 4;
  static constexpr std::uint8_t kStateLoadingWorld = 5;
  std::uint8_t state = 0;
  static void visit(auto& self, auto&& field) { field("state", self.state); }
  bool operator==(const SimulationState&) const = default;
};

struct SimulatorFeatures {
  static constexpr const char* kName = "simulation_interfaces/msg/SimulatorFeatures";
  static constexpr std::uint8_t kSpawning = 0;
  static constexpr std::uint8_t kDeleting = 1;
  static constexpr std::uint8_t kNamedPoses = 2;
  static constexpr std::uint8_t kPoseBounds = 3;
  static constexpr std::uint8_t kEntityTags = 4;
  static constexpr std::uint8_t kEntityBounds = 5;
  static constexpr std::uint8_t kEntityBoundsBox = 6;
  static constexpr std::uint8_t kEntityBoundsConvex = 7;
  static constexpr std::uint8_t kEntityCategories = 8;
  static constexpr std::uint8_t kSpawningResourceString = 9;
  static constexpr std::uint8_t kEntityStateGetting = 10;
  static constexpr std::uint8_t kEntityStateSetting = 11;
  static constexpr std::uint8_t kEntityInfoGetting = 12;
  static constexpr std::uint8_t kEntityInfoSetting = 13;
  static constexpr std::uint8_t kSpawnables = 14;
  static constexpr std::uint8_t kSimulationReset = 20;
  static constexpr std::uint8_t kSimulationResetTime = 21;
  static constexpr std::uint8_t kSimulationResetState = 22;
  static constexpr std::uint8_t kSimulationResetSpawned = 23;
  static constexpr std::uint8_t kSimulationStateGetting = 24;
  static constexpr std::uint8_t kSimulationStateSetting = 25;
  static constexpr std::uint8_t kSimulationStatePause = 26;
  static constexpr std::uint8_t kStepSimulationSingle = 31;
  static constexpr std::uint8_t kStepSimulationMultiple = 32;
  static constexpr std::uint8_t kStepSimulationAction = 33;
  static constexpr std::uint8_t kWorldLoading = 40;
  static constexpr std::uint8_t kWorldResourceString = 41;
  static constexpr std::uint8_t kWorldTags = 42;
  static constexpr std::uint8_t kWorldUnloading = 43;
  static constexpr std::uint8_t kWorldInfoGetting = 44;
  static constexpr std::uint8_t kAvailableWorlds = 45;
  static constexpr std::uint8_t kSpawningEntities = 50;
  std::vector<std::uint16_t> features;
  std::vector<std::string> spawn_formats;
  std::string custom_info;
  static void visit(auto& self, auto&& field) {
    field("features", self.features);
    field("spawn_formats", self.spawn_formats);
    field("custom_info", self.custom_info);
  }
  bool operator==(const SimulatorFeatures&) const = default;
};

struct SpawnEntity {
  static constexpr const char* kName = "simulation_interfaces/msg/SpawnEntity";
  std::string name;
  bool allow_renaming = false;
  Resource entity_resource;
  std::string entity_namespace;
  geometry_msgs::PoseStamped initial_pose;
  static void visit(auto& self, auto&& field) {
    field("name", self.name);
    field("allow_renaming", self.allow_renaming);
    field("entity_resource", self.entity_resource);
    field("entity_namespace", self.entity_namespace);
    field("initial_pose", self.initial_pose);
  }
  bool operator==(const SpawnEntity&) const = default;
};

struct SpawnResult {
  static constexpr const char* kName = "simulation_interfaces/msg/SpawnResult";
  static constexpr std::uint8_t kNameNotUnique = 101;
  static constexpr std::uint8_t kNameInvalid = 102;
  static constexpr std::uint8_t kUnsupportedFormat = 103;
  static constexpr std::uint8_t kNoResource = 104;
  static constexpr std::uint8_t kNamespaceInvalid = 105;
  static constexpr std::uint8_t kResourceParseError = 106;
  static constexpr std::uint8_t kMissingAssets = 107;
  static constexpr std::uint8_t kUnsupportedAssets = 108;
  static constexpr std::uint8_t kInvalidPose = 109;
  Result result;
  std::string entity_name;
  static void visit(auto& self, auto&& field) {
    field("result", self.result);
    field("entity_name", self.entity_name);
  }
  bool operator==(const SpawnResult&) const = default;
};

struct Spawnable {
  static constexpr const char* kName = "simulation_interfaces/msg/Spawnable";
  Resource entity_resource;
  std::string description;
  Bounds spawn_bounds;
  static void visit(auto& self, auto&& field) {
    field("entity_resource", self.entity_resource);
    field("description", self.description);
    field("spawn_bounds", self.spawn_bounds);
  }
  bool operator==(const Spawnable&) const = default;
};

struct WorldResource {
  static constexpr const char* kName = "simulation_interfaces/msg/WorldResource";
  std::string name;
  Resource world_resource;
  std::string description;
  std::vector<std::string> tags;
  static void visit(auto& self, auto&& field) {
    field("name", self.name);
    field("world_resource", self.world_resource);
    field("description", self.description);
    field("tags", self.tags);
  }
  bool operator==(const WorldResource&) const = default;
};

}  // namespace pongsim::ros2::simulation_interfaces
