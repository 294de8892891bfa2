#include "msgs/state/visible_world.hh"

#include <ignition/msgs/actor.pb.h>
#include <ignition/msgs/geometry.pb.h>
#include <ignition/msgs/light.pb.h>
#include <ignition/msgs/material.pb.h>
#include <ignition/msgs/scene.pb.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "assets/finder.hh"
#include "msgs/scene/actor_message.hh"
#include "msgs/scene/geometry_message.hh"
#include "msgs/scene/light_message.hh"
#include "msgs/scene/material_message.hh"
#include "msgs/scene/surroundings_message.hh"
#include "msgs/state/component_reader.hh"
#include "sdf/readers/shapes/extrusion.hh"

namespace pongsim::msgs {

namespace {

namespace im = ignition::msgs;

/// Finds the files named in a state, each once.
class FileSearch {
 public:
  explicit FileSearch(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// @param kind "mesh"
  std::filesystem::path find(const std::string& kind, const std::string& address) {
    if (address.empty()) return {};
    Diagnostics reasons;
    const auto found = find_(address, {}, {}, reasons);
    if (found) return *found;
    if (said_.insert(address).second) {
      diagnostics_.warning({}, kind + " '" + address + "' is not on this machine: it will be missing from the picture",
                           "run 'view' where the world runs, or set PONGSIM_RESOURCE_PATH to the folder of its models");
    }
    return {};
  }

 private:
  Diagnostics& diagnostics_;
  const assets::Finder find_ = assets::finderIn(assets::Places::fromEnvironment());
  std::set<std::string> said_;
};

/// Components that decide what an entity looks like.
constexpr std::array kLooks{"Name",          "ParentEntity",    "Pose",       "Scene",    "Visual",   "CastShadows",
                            "Transparency",  "VisibilityFlags", "LaserRetro", "Geometry", "Material", "Actor",
                            "TrajectoryPose"};

class VisibleWorldReader {
 public:
  VisibleWorldReader(const im::SerializedStateMap& state, Diagnostics& diagnostics)
      : state_(state), files_(diagnostics) {
    for (const auto& [id, entity] : state.entities()) {
      const ComponentReader components(entity);
      if (components.has("World")) world_ = id;
      if (const auto parent = components.number("ParentEntity"); parent && *parent >= 0) {
        children_[static_cast<std::uint64_t>(*parent)].push_back(id);
      }
    }
    for (auto& [parent, children] : children_) std::ranges::sort(children);
  }

  description::World read() {
    description::World world;
    if (!state_.entities().contains(world_)) return world;
    const ComponentReader components = componentsOf(world_);
    world.name = components.text("Name");
    if (const auto scene = components.message<im::Scene>("Scene")) world.scene = surroundingsFrom(*scene);
    for (const std::uint64_t id : childrenOf(world_)) {
      if (componentsOf(id).has("Model")) world.models.push_back(readModel(id, 0));
      if (componentsOf(id).has("Light")) addLight(id, world.lights);
      addActor(id, world.actors);
    }
    return world;
  }

 private:
  /// Nobody makes models nested deeper than this.
  static constexpr int kDeepest = 100;

  ComponentReader componentsOf(std::uint64_t id) const { return ComponentReader(state_.entities().at(id)); }

  const std::vector<std::uint64_t>& childrenOf(std::uint64_t id) { return children_[id]; }

  static Pose poseOf(const ComponentReader& components) {
    const Pose pose = poseOfComponent(components.text("Pose")).value_or(Pose());
    const bool isSound = pose.position.allFinite() && pose.rotation.coeffs().allFinite();
    return isSound ? pose : Pose();
  }

  description::Model readModel(std::uint64_t id, int depth) {
    const ComponentReader components = componentsOf(id);
    description::Model model;
    model.name = components.text("Name");
    model.isStatic = true;
    model.X_ParentModel = poseOf(components);
    for (const std::uint64_t child : childrenOf(id)) {
      if (componentsOf(child).has("Link")) model.links.push_back(readLink(child));
      if (componentsOf(child).has("Model") && depth < kDeepest) model.models.push_back(readModel(child, depth + 1));
    }
    if (!model.links.empty()) model.canonicalLink = model.links.front().name;
    return model;
  }

  description::Link readLink(std::uint64_t id) {
    const ComponentReader components = componentsOf(id);
    description::Link link;
    link.name = components.text("Name");
    link.X_ModelLink = poseOf(components);
    for (const std::uint64_t child : childrenOf(id)) {
      if (componentsOf(child).has("Visual")) link.visuals.push_back(readVisual(componentsOf(child)));
      if (componentsOf(child).has("Light")) addLight(child, link.lights);
    }
    return link;
  }

  description::Visual readVisual(const ComponentReader& components) {
    description::Visual visual;
    visual.name = components.text("Name");
    visual.X_LinkVisual = poseOf(components);
    visual.castsShadows = components.text("CastShadows") != "0";
    visual.transparency = base::parseDouble(components.text("Transparency")).value_or(0);
    visual.visibilityFlags =
        static_cast<std::uint32_t>(components.number("VisibilityFlags").value_or(visual.visibilityFlags));
    visual.laserRetro = base::parseDouble(components.text("LaserRetro")).value_or(0);
    if (const auto geometry = components.message<im::Geometry>("Geometry")) {
      visual.geometry = geometryFrom(*geometry);
      complete(visual.geometry);
    }
    if (const auto material = components.message<im::Material>("Material")) {
      visual.material = materialFrom(*material);
      complete(*visual.material);
    }
    return visual;
  }

  /// Adds the entity if it is an actor.
  void addActor(std::uint64_t id, std::vector<description::Actor>& actors) {
    const auto message = componentsOf(id).message<im::Actor>("Actor");
    if (!message) return;
    description::Actor& actor = actors.emplace_back(actorFrom(*message));
    actor.skin.file = files_.find("skin", actor.skin.uri);
    if (const auto moved = poseOfComponent(componentsOf(id).text("TrajectoryPose"))) {
      actor.X_WorldActor = poseOf(componentsOf(id)) * *moved;
      actor.trajectories.clear();
    }
    for (const std::uint64_t child : childrenOf(id)) {
      if (componentsOf(child).has("Visual")) actor.visuals.push_back(readVisual(componentsOf(child)));
    }
  }

  void addLight(std::uint64_t id, std::vector<description::Light>& lights) {
    const auto message = componentsOf(id).message<im::Light>("Light");
    if (!message) return;
    description::Light& light = lights.emplace_back(lightFrom(*message));
    light.name = componentsOf(id).text("Name");
    light.X_ParentLight = poseOf(componentsOf(id));
  }

  void complete(description::Geometry& geometry) {
    if (auto* mesh = std::get_if<description::Mesh>(&geometry)) mesh->file = files_.find("mesh", mesh->uri);
    if (auto* heightmap = std::get_if<description::Heightmap>(&geometry)) {
      heightmap->file = files_.find("heightmap", heightmap->uri);
    }
    if (auto* polyline = std::get_if<description::Polyline>(&geometry)) {
      std::size_t count = 0;
      bool areSound = std::isfinite(polyline->height) && polyline->height > 0;
      for (const auto& line : polyline->lines) {
        count += line.size();
        areSound =
            areSound && line.size() >= 3 && std::ranges::all_of(line, [](const auto& p) { return p.allFinite(); });
      }
      if (areSound && count > 0 && count <= sdf::kMostOutlinePoints && !sdf::crosses(polyline->lines)) {
        polyline->triangles = sdf::extrude(polyline->lines, polyline->height);
      }
    }
  }

  void complete(description::Material& material) {
    // only textures that are drawn
    const auto find = [this](description::Texture& texture) { texture.file = files_.find("texture", texture.uri); };
    for (description::PbrMaps* maps :
         {material.metal ? &material.metal->maps : nullptr, material.gloss ? &material.gloss->maps : nullptr}) {
      if (maps == nullptr) continue;
      for (description::Texture* texture : {&maps->albedo, &maps->normal, &maps->emissive}) find(*texture);
    }
    if (!material.metal) return;
    find(material.metal->roughnessMap);
    find(material.metal->metalnessMap);
  }

  const im::SerializedStateMap& state_;
  FileSearch files_;
  std::uint64_t world_ = 0;
  std::map<std::uint64_t, std::vector<std::uint64_t>> children_;
};

}  // namespace

description::World visibleWorld(const Message& step, Diagnostics& diagnostics) {
  return VisibleWorldReader(static_cast<const im::SerializedStepMap&>(step).state(), diagnostics).read();
}

bool haveSameLooks(const Message& a, const Message& b) {
  const auto& before = static_cast<const im::SerializedStepMap&>(a).state().entities();
  const auto& after = static_cast<const im::SerializedStepMap&>(b).state().entities();
  if (before.size() != after.size()) return false;
  return std::ranges::all_of(before, [&after](const auto& entry) {
    const auto other = after.find(entry.first);
    if (other == after.end()) return false;
    const ComponentReader one(entry.second), two(other->second);
    return std::ranges::all_of(kLooks, [&](const char* component) {
      const bool moves = component == std::string_view("Pose") && !one.has("Visual") && !one.has("Actor");
      const std::string *const x = one.find(component), *const y = two.find(component);
      return moves || (x == nullptr || y == nullptr ? x == y : *x == *y);
    });
  });
}

}  // namespace pongsim::msgs
