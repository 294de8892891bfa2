#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ros2/types/simulation_interfaces.hh"

/// The services about the simulation and its worlds.
namespace pongsim::ros2::simulation_interfaces {

namespace srv {

struct GetAvailableWorlds {
  static constexpr const char* kName = "simulation_interfaces/srv/GetAvailableWorlds";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/GetAvailableWorlds_Request";
    std::vector<std::string> additional_sources;
    simulation_interfaces::TagsFilter filter;
    bool offline_only = false;
    bool continue_on_error = false;
    static void visit(auto& self, auto&& field) {
      field("additional_sources", self.additional_sources);
      field("filter", self.filter);
      field("offline_only", self.offline_only);
      field("continue_on_error", self.continue_on_error);
    }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/GetAvailableWorlds_Response";
    static constexpr std::uint8_t kDefaultSourcesFailed = 101;
    simulation_interfaces::Result result;
    std::vector<simulation_interfaces::WorldResource> worlds;
    static void visit(auto& self, auto&& field) {
      field("result", self.result);
      field("worlds", self.worlds);
    }
    bool operator==(const Response&) const = default;
  };
};

struct GetCurrentWorld {
  static constexpr const char* kName = "simulation_interfaces/srv/GetCurrentWorld";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/GetCurrentWorld_Request";
    static void visit(auto&, auto&&) {}
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/GetCurrentWorld_Response";
    static constexpr std::uint8_t kNoWorldLoaded = 101;
    simulation_interfaces::Result result;
    simulation_interfaces::WorldResource world;
    static void visit(auto& self, auto&& field) {
      field("result", self.result);
      field("world", self.world);
    }
    bool operator==(const Response&) const = default;
  };
};

struct GetSimulationState {
  static constexpr const char* kName = "simulation_interfaces/srv/GetSimulationState";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/GetSimulationState_Request";
    static void visit(auto&, auto&&) {}
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/GetSimulationState_Response";
    simulation_interfaces::SimulationState state;
    simulation_interfaces::Result result;
    static void visit(auto& self, auto&& field) {
      field("state", self.state);
      field("result", self.result);
    }
    bool operator==(const Response&) const = default;
  };
};

struct GetSimulatorFeatures {
  static constexpr const char* kName = "simulation_interfaces/srv/GetSimulatorFeatures";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/GetSimulatorFeatures_Request";
    static void visit(auto&, auto&&) {}
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/GetSimulatorFeatures_Response";
    simulation_interfaces::SimulatorFeatures features;
    static void visit(auto& self, auto&& field) { field("features", self.features); }
    bool operator==(const Response&) const = default;
  };
};

struct LoadWorld {
  static constexpr const char* kName = "simulation_interfaces/srv/LoadWorld";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/LoadWorld_Request";
    simulation_interfaces::Resource world_resource;
    bool fail_on_unsupported_element = false;
    bool ignore_missing_or_unsupported_assets = false;
    static void visit(auto& self, auto&& field) {
      field("world_resource", self.world_resource);
      field("fail_on_unsupported_element", self.fail_on_unsupported_element);
      field("ignore_missing_or_unsupported_assets", self.ignore_missing_or_unsupported_assets);
    }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/LoadWorld_Response";
    static constexpr std::uint8_t kUnsupportedFormat = 101;
    static constexpr std::uint8_t kNoResource = 102;
    static constexpr std::uint8_t kResourceParseError = 103;
    static constexpr std::uint8_t kMissingAssets = 104;
    static constexpr std::uint8_t kUnsupportedAssets = 105;
    static constexpr std::uint8_t kUnsupportedElements = 106;
    simulation_interfaces::Result result;
    simulation_interfaces::WorldResource world;
    static void visit(auto& self, auto&& field) {
      field("result", self.result);
      field("world", self.world);
    }
    bool operator==(const Response&) const = default;
  };
};

struct ResetSimulation {
  static constexpr const char* kName = "simulation_interfaces/srv/ResetSimulation";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/ResetSimulation_Request";
    static constexpr std::uint8_t kScopeDefault = 0;
    static constexpr std::uint8_t kScopeTime = 1;
    static constexpr std::uint8_t kScopeState = 2;
    static constexpr std::uint8_t kScopeSpawned = 4;
    static constexpr std::uint8_t kScopeAll = 255;
    std::uint8_t scope = 0;
    static void visit(auto& self, auto&& field) { field("scope", self.scope); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/ResetSimulation_Response";
    simulation_interfaces::Result result;
    static void visit(auto& self, auto&& field) { field("result", self.result); }
    bool operator==(const Response&) const = default;
  };
};

struct SetSimulationState {
  static constexpr const char* kName = "simulation_interfaces/srv/SetSimulationState";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/SetSimulationState_Request";
    simulation_interfaces::SimulationState state;
    static void visit(auto& self, auto&& field) { field("state", self.state); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/SetSimulationState_Response";
    static constexpr std::uint8_t kAlreadyInTargetState = 101;
    static constexpr std::uint8_t kStateTransitionError = 102;
    static constexpr std::uint8_t kIncorrectTransition = 103;
    simulation_interfaces::Result result;
    static void visit(auto& self, auto&& field) { field("result", self.result); }
    bool operator==(const Response&) const = default;
  };
};

struct StepSimulation {
  static constexpr const char* kName = "simulation_interfaces/srv/StepSimulation";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/StepSimulation_Request";
    std::uint64_t steps = 1;
    static void visit(auto& self, auto&& field) { field("steps", self.steps); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/StepSimulation_Response";
    simulation_interfaces::Result result;
    static void visit(auto& self, auto&& field) { field("result", self.result); }
    bool operator==(const Response&) const = default;
  };
};

struct UnloadWorld {
  static constexpr const char* kName = "simulation_interfaces/srv/UnloadWorld";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/UnloadWorld_Request";
    static void visit(auto&, auto&&) {}
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/UnloadWorld_Response";
    static constexpr std::uint8_t kNoWorldLoaded = 101;
    simulation_interfaces::Result result;
    static void visit(auto& self, auto&& field) { field("result", self.result); }
    bool operator==(const Response&) const = default;
  };
};

}  // namespace srv

}  // namespace pongsim::ros2::simulation_interfaces
