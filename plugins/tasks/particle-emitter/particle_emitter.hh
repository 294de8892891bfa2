#pragma once

#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/particle_emitter.pb.h>
#include <ignition/msgs/particle_emitter_v.pb.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "pongsim/commands.hh"
#include "pongsim/messages/fields.hh"
#include "pongsim/parameters.hh"
#include "pongsim/scene.hh"
#include "pongsim/system.hh"

namespace pongsim {

/// Changes particle emitters on command: in a model the one that its parameters describe, in a world those of all
/// links. The emitters themselves are part of what is read from the file.
class ParticleEmitter : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is(
        "Changes particle emitters on command. In a model it also adds the one that its parameters describe; in a "
        "world it has none, and changes those of all links.",
        Declaration::Place::kAnywhere);
    declaration.element("emitter_name", "name E of the emitter; `particle_emitter_entity` if not given");
    declaration.element("type", "point, box, cylinder or ellipsoid");
    declaration.element("pose", "in the model's frame; particles fly along its x axis");
    declaration.element("size", "of the volume in which particles begin: along y, z and x [m]");
    declaration.element("rate", "particles per second; 10 if not given");
    declaration.element("duration", "how long it emits [s]; 0 or less: for ever");
    declaration.element("emitting", "whether it emits from the start; false if not given");
    declaration.element("particle_size", "width and height of particles [m]");
    declaration.element("lifetime", "of a particle [s]; 5 if not given");
    declaration.element("min_velocity", "slowest speed of particles [m/s]; 1 if not given");
    declaration.element("max_velocity", "fastest speed of particles [m/s]; 1 if not given");
    declaration.element("color_start", "of a new particle; white if not given");
    declaration.element("color_end", "of a particle at its end; white if not given");
    declaration.element("scale_rate", "growth of width and height [m/s]; 1 if not given");
    declaration.element("color_range_image", "image with the colours of a particle's life, from left to right");
    declaration.element("particle_scatter_ratio", "share of beams that particles reflect; 0.65 if not given");
    declaration.element("material", "of the particles, as in a visual: diffuse colour and albedo map");
    declaration.element("allow_renaming", "has no effect: names count for each model");
    declaration.parameter("topic", &topic_, "", "command topic in a model").otherwise("/model/M/particle_emitter/E");
    declaration.subscribes("<topic>", "ignition.msgs.ParticleEmitter", "in a model: changes what the message sets");
    declaration.subscribes("/model/M/link/L/particle_emitter/E/cmd", "ignition.msgs.ParticleEmitter",
                           "in a world, or on the emitter's `<topic>`: changes what the message sets");
    declaration.serves("/world/W/particle_emitters", "ignition.msgs.Empty", "ignition.msgs.ParticleEmitter_V",
                       "in a world: all emitters");
  }

  void configure(const SystemContext& context) override {
    log_ = &context.log;
    world_ = &context.world;
    node_ = &context.node;
    model_ = context.model;
    scene_.emplace(*world_);
    const Element* name = context.sdf.child("emitter_name");
    name_ = name != nullptr ? name->text : kDefaultName;
    if (!model_) {
      service_ = node_->serve<ignition::msgs::Empty, ignition::msgs::ParticleEmitter_V>(
          "/world/" + std::string(world_->name()) + "/particle_emitters",
          [this](const auto&, auto& reply) { return list(reply); });
    }
    worldChanged();
  }

  void worldChanged() override {
    const std::vector<EmitterPlace> emitters = scene_->emitters();
    std::erase_if(commands_, [&](const auto& command) {
      return std::ranges::find(emitters, command.first, &EmitterPlace::id) == emitters.end();
    });
    for (const EmitterPlace& emitter : emitters) {
      if (commands_.contains(emitter.id) || !isMine(emitter)) continue;
      commands_[emitter.id] = node_->subscribe<ignition::msgs::ParticleEmitter>(
          topicOf(emitter), [this, id = emitter.id](const auto& message) { change(id, message); }, kCommands);
    }
  }

 private:
  static constexpr const char* kDefaultName = "particle_emitter_entity";

  /// @return "/model/outer/model/inner".
  static std::string topicOf(const Model& model) {
    const std::optional<Model> parent = model.parent();
    return (parent ? topicOf(*parent) : std::string()) + "/model/" + std::string(model.name());
  }

  Link linkOf(const EmitterPlace& emitter) const { return *world_->link(emitter.link); }

  bool isMine(const EmitterPlace& emitter) const {
    return !model_ || (emitter.name == name_ && linkOf(emitter).model().id() == model_->id());
  }

  std::string topicOf(const EmitterPlace& emitter) const {
    if (model_) return topicOr(topic_, "/model/" + std::string(model_->name()) + "/particle_emitter/" + emitter.name);
    const Link link = linkOf(emitter);
    return topicOr(emitter.topic, topicOf(link.model()) + "/link/" + std::string(link.name()) + "/particle_emitter/" +
                                      emitter.name + "/cmd");
  }

  void change(EmitterId id, const ignition::msgs::ParticleEmitter& message) {
    const Outcome<void> changed = scene_->changeEmitter(id, message);
    if (!changed) log_->warning("a particle emitter is not changed: " + changed.error);
  }

  ServiceAnswer list(ignition::msgs::ParticleEmitter_V& reply) const {
    for (const EmitterPlace& emitter : scene_->emitters()) {
      ignition::msgs::ParticleEmitter& added = *reply.add_particle_emitter();
      scene_->fillInEmitter(emitter.id, added);
      setHeaderValue("topic", topicOf(emitter), *added.mutable_header());
      setHeaderValue("frame", linkOf(emitter).scopedName(), *added.mutable_header());
    }
    return true;
  }

  std::string topic_;
  std::string name_;
  const Logger* log_ = nullptr;
  World* world_ = nullptr;
  Node* node_ = nullptr;
  std::optional<Model> model_;
  std::optional<Scene> scene_;
  std::map<EmitterId, Subscription> commands_;
  Service service_;
};

}  // namespace pongsim
