#include "cli/world/world_info.hh"

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

#include "msgs/control/status_messages.hh"
#include "msgs/state/state_reader.hh"

namespace pongsim::cli {

namespace {

using msgs::EntityState;

struct WorldCounts {
  std::string name;
  Vector3 gravity = Vector3::Zero();
  int models = 0, staticModels = 0, links = 0, joints = 0, sensors = 0, lights = 0;
};

WorldCounts countsOf(const std::vector<EntityState>& entities) {
  WorldCounts counts;
  for (const EntityState& entity : entities) {
    switch (entity.kind) {
      case EntityState::Kind::kWorld:
        counts.name = entity.name;
        counts.gravity = entity.gravity.value_or(counts.gravity);
        break;
      case EntityState::Kind::kModel:
        ++counts.models;
        if (entity.isStatic) ++counts.staticModels;
        break;
      case EntityState::Kind::kLink:
        ++counts.links;
        break;
      case EntityState::Kind::kJoint:
        ++counts.joints;
        break;
      case EntityState::Kind::kSensor:
        ++counts.sensors;
        break;
      case EntityState::Kind::kLight:
        ++counts.lights;
        break;
      case EntityState::Kind::kOther:
        break;
    }
  }
  return counts;
}

}  // namespace

std::string worldInfo(const Message& step, bool asJson) {
  const WorldCounts counts = countsOf(msgs::entitiesOf(step));
  const msgs::Status status = msgs::statusOfState(step);
  if (asJson) {
    const nlohmann::ordered_json json = {{"name", counts.name},
                                         {"models", counts.models},
                                         {"staticModels", counts.staticModels},
                                         {"links", counts.links},
                                         {"joints", counts.joints},
                                         {"sensors", counts.sensors},
                                         {"lights", counts.lights},
                                         {"gravity", {counts.gravity.x(), counts.gravity.y(), counts.gravity.z()}},
                                         {"stepSize", toSeconds(status.stepSize)},
                                         {"simulated", toSeconds(status.simulated)},
                                         {"iterations", status.iterations},
                                         {"paused", status.paused}};
    return json.dump() + "\n";
  }
  std::array<char, 512> text{};
  std::snprintf(text.data(), text.size(),
                "  models      %d, %d of them static\n  links       %d\n  joints      %d\n  sensors     %d\n"
                "  lights      %d\n  gravity     %g %g %g m/s^2\n  step        %g s\n  simulated   %.3f s\n"
                "  iterations  %llu\n  state       %s\n",
                counts.models, counts.staticModels, counts.links, counts.joints, counts.sensors, counts.lights,
                counts.gravity.x(), counts.gravity.y(), counts.gravity.z(), toSeconds(status.stepSize),
                toSeconds(status.simulated), static_cast<unsigned long long>(status.iterations),
                status.paused ? "paused" : "running");
  return "World: " + counts.name + "\n" + text.data();
}

}  // namespace pongsim::cli
