#include "msgs/scene/scene_message.hh"

#include <ignition/msgs/scene.pb.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "msgs/scene/emitter_message.hh"
#include "msgs/scene/geometry_message.hh"
#include "msgs/scene/light_message.hh"
#include "msgs/scene/material_message.hh"
#include "pongsim/messages/fields.hh"
#include "world/particles.hh"

namespace pongsim::msgs {

namespace {

namespace im = ignition::msgs;
using world::kNoSlot;
using world::Slot;

/// Ids in messages have 32 bits.
template <class Id>
std::uint32_t numberOf(Id id) {
  return static_cast<std::uint32_t>(id.value);
}

class SceneWriter {
 public:
  SceneWriter(const world::Entities& entities, const world::State& state, const ChangedProperties& changed)
      : entities_(entities), state_(state), changed_(changed) {}

  void writeModel(Slot slot, im::Model& message) const {
    const world::ModelRecord& model = entities_.models()[slot];
    message.set_name(model.description->name);
    message.set_id(numberOf(model.id));
    setPose(world::poseInParent(entities_, state_, slot), *message.mutable_pose());
    for (const Slot inner : model.models) writeModel(inner, *message.add_model());
    for (const Slot link : model.links) writeLink(link, *message.add_link());
  }

  void writeLight(const world::LightRecord& light, std::uint32_t parent, im::Light& message) const {
    setLight(*light.description, message);
    message.set_id(numberOf(light.id));
    message.set_parent_id(parent);
  }

 private:
  void writeLink(Slot slot, im::Link& message) const {
    const world::LinkRecord& link = entities_.links()[slot];
    message.set_id(numberOf(link.id));
    message.set_name(link.description->name);
    setPose(world::poseInModel(entities_, state_, slot), *message.mutable_pose());
    for (std::size_t i = 0; i < link.description->visuals.size(); ++i) {
      const description::Visual& visual = link.description->visuals[i];
      im::Visual& added = *message.add_visual();
      added.set_name(visual.name);
      added.set_id(numberOf(visualId(link, i)));
      added.set_parent_id(numberOf(link.id));
      added.set_cast_shadows(visual.castsShadows);
      setPose(visual.X_LinkVisual, *added.mutable_pose());
      setGeometry(visual.geometry, *added.mutable_geometry());
      if (const auto material = materialNow(visual, visualId(link, i), changed_)) {
        setMaterial(*material, *added.mutable_material());
      }
    }
    for (std::size_t i = 0; i < link.description->emitters.size(); ++i) {
      setEmitter(link.description->emitters[i], world::emitterId(link, i).value, *message.add_particle_emitter());
    }
    for (const world::LightRecord& light : entities_.lights()) {
      if (light.link == slot) writeLight(light, numberOf(link.id), *message.add_light());
    }
    for (const world::SensorRecord& sensor : entities_.sensors()) {
      if (sensor.link != slot) continue;
      im::Sensor& added = *message.add_sensor();
      added.set_name(sensor.description->name);
      added.set_id(numberOf(sensor.id));
      added.set_parent_id(numberOf(link.id));
      setPose(sensor.description->X_ParentSensor, *added.mutable_pose());
    }
  }

  const world::Entities& entities_;
  const world::State& state_;
  const ChangedProperties& changed_;
};

class GraphWriter {
 public:
  void addNode(std::uint64_t id, std::string_view name) { nodes_.push_back({id, std::string(name)}); }
  void addEdge(std::uint64_t from, std::uint64_t to) {
    edges_ += "  " + std::to_string(from) + " -> " + std::to_string(to) + " [label=1];\n";
  }
  /// Adds a child of something else.
  template <class Parent, class Child>
  void add(Parent parent, Child child, std::string_view name) {
    addNode(child.value, name);
    addEdge(parent.value, child.value);
  }

  std::string text() {
    std::ranges::sort(nodes_, {}, &Node::id);
    std::string text = "digraph {\n";
    for (const Node& node : nodes_) {
      const std::string id = std::to_string(node.id);
      text += "  " + id + " [label=\"" + escaped(node.name) + " (" + id + ")\"];\n";
    }
    return text + edges_ + "}\n";
  }

 private:
  struct Node {
    std::uint64_t id;
    std::string name;
  };

  static std::string escaped(std::string_view name) {
    std::string text;
    for (const char letter : name) {
      if (letter == '"' || letter == '\\') text += '\\';
      text += letter;
    }
    return text;
  }

  std::vector<Node> nodes_;
  std::string edges_;
};

}  // namespace

void setScene(const world::Entities& entities, const world::State& state, Message& scene,
              const std::function<bool(std::uint64_t)>& isWanted, const ChangedProperties& changed) {
  auto& message = static_cast<im::Scene&>(scene);
  message.Clear();
  const SceneWriter writer(entities, state, changed);
  for (const Slot model : entities.topLevelModels()) {
    if (!isWanted || isWanted(entities.models()[model].id.value)) writer.writeModel(model, *message.add_model());
  }
  for (const world::LightRecord& light : world::present(entities.lights())) {
    if (light.link != kNoSlot || (isWanted && !isWanted(light.id.value))) continue;
    writer.writeLight(light, numberOf(entities.worldId()), *message.add_light());
  }
}

std::string sceneGraph(const world::Entities& entities) {
  GraphWriter graph;
  graph.addNode(entities.worldId().value, entities.description().name);
  for (const world::ModelRecord& model : world::present(entities.models())) {
    const std::uint64_t parent =
        model.parent == kNoSlot ? entities.worldId().value : entities.models()[model.parent].id.value;
    graph.addNode(model.id.value, model.description->name);
    graph.addEdge(parent, model.id.value);
  }
  for (const world::LinkRecord& link : world::present(entities.links())) {
    graph.add(entities.models()[link.model].id, link.id, link.description->name);
  }
  for (const world::LinkRecord& link : world::present(entities.links())) {
    for (std::size_t i = 0; i < link.description->visuals.size(); ++i) {
      graph.add(link.id, visualId(link, i), link.description->visuals[i].name);
    }
    for (std::size_t i = 0; i < link.description->emitters.size(); ++i) {
      graph.add(link.id, world::emitterId(link, i), link.description->emitters[i].name);
    }
  }
  for (const world::LightRecord& light : world::present(entities.lights())) {
    const std::uint64_t parent =
        light.link == kNoSlot ? entities.worldId().value : entities.links()[light.link].id.value;
    graph.addNode(light.id.value, light.description->name);
    graph.addEdge(parent, light.id.value);
  }
  for (const world::SensorRecord& sensor : world::present(entities.sensors())) {
    if (sensor.link != kNoSlot) graph.add(entities.links()[sensor.link].id, sensor.id, sensor.description->name);
  }
  return graph.text();
}

}  // namespace pongsim::msgs
