#include "sdf/readers/models/emitter_reader.hh"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "sdf/includes/asset_file.hh"
#include "sdf/readers/shapes/material_reader.hh"
#include "sdf/text/names.hh"

namespace pongsim::sdf {

namespace {

constexpr std::array<std::string_view, 4> kEmitterTypes{"point", "box", "cylinder", "ellipsoid"};

/// @return Whether it is the system of models. That of worlds has the same name in Gazebo's later releases.
bool describesEmitter(const description::Plugin& plugin) {
  if (plugin.className.empty()) return plugin.filename.find("-particle-emitter-system") != std::string::npos;
  return plugin.className.ends_with("systems::ParticleEmitter");
}

/// @return The plugin as a `<particle_emitter>`, which has other defaults, and its type and name as attributes.
Element emitterOf(const Element& plugin, const std::string& label, Context& context) {
  Element element;
  element.name = "particle_emitter";
  element.position = plugin.position;
  const Element* name = plugin.child("emitter_name");
  element.attributes.push_back({"name", name != nullptr ? name->text : "particle_emitter_entity", plugin.position});
  if (const Element* type = plugin.child("type"); type != nullptr && !type->text.empty()) {
    if (std::ranges::find(kEmitterTypes, type->text) != kEmitterTypes.end()) {
      element.attributes.push_back({"type", type->text, type->position});
    } else {
      context.diagnostics.warning(type->position,
                                  "particle-emitter of " + label + ": <type> is '" + type->text + "': point is used",
                                  "use point, box, cylinder or ellipsoid");
    }
  }
  for (const auto& [child, value] : {std::pair("emitting", "false"), std::pair("scale_rate", "1")}) {
    if (plugin.child(child) == nullptr) element.children.push_back({child, value, {}, {}, plugin.position});
  }
  for (const Element& child : plugin.children) {
    if (child.name != "emitter_name" && child.name != "type") element.children.push_back(child);
  }
  return element;
}

}  // namespace

EmitterDraft readEmitter(const Element& element, const std::string& owner, Context& context) {
  using enum description::ParticleEmitter::Type;
  constexpr std::array kTypeOfWord{kPoint, kBox, kCylinder, kEllipsoid};
  EmitterDraft draft;
  description::ParticleEmitter& emitter = draft.emitter;
  emitter.name = readName(element, owner, context);
  emitter.position = element.position;
  draft.pose = readPose(element, context);
  emitter.type = kTypeOfWord[readWordAttribute(element, "type", 0, kEmitterTypes, context)];
  emitter.size = readVector(element, "size", emitter.size, context);
  emitter.rate = readNumber(element, "rate", emitter.rate, context);
  emitter.duration = readNumber(element, "duration", emitter.duration, context);
  emitter.isEmitting = readFlag(element, "emitting", emitter.isEmitting, context);
  emitter.particleSize = readVector(element, "particle_size", emitter.particleSize, context);
  emitter.lifetime = readNumber(element, "lifetime", emitter.lifetime, context);
  emitter.minVelocity = readNumber(element, "min_velocity", emitter.minVelocity, context);
  emitter.maxVelocity = readNumber(element, "max_velocity", emitter.maxVelocity, context);
  emitter.colorStart = readColor(element, "color_start", emitter.colorStart, context);
  emitter.colorEnd = readColor(element, "color_end", emitter.colorEnd, context);
  emitter.scaleRate = readNumber(element, "scale_rate", emitter.scaleRate, context);
  emitter.colorRange = readTexture(element, "color_range_image", context);
  emitter.topic = readText(element, "topic", "");
  emitter.scatterRatio = readNumber(element, "particle_scatter_ratio", emitter.scatterRatio, context);
  if (const Element* material = element.child("material")) emitter.material = readMaterial(*material, context);
  if (const std::string fault = faultOf(emitter); !fault.empty()) {
    context.diagnostics.warning(element.position, partLabel(element, emitter.name, owner) + " emits nothing: " + fault);
    description::ParticleEmitter harmless;
    harmless.name = emitter.name;
    harmless.position = emitter.position;
    harmless.topic = emitter.topic;
    harmless.isEmitting = false;
    emitter = std::move(harmless);
  }
  return draft;
}

description::ParticleEmitter finishEmitter(EmitterDraft&& draft, const Scope& scope, const Pose& X_ScopeLink,
                                           Context& context) {
  description::ParticleEmitter emitter = std::move(draft.emitter);
  emitter.X_LinkEmitter = draft.pose.value;
  if (!draft.pose.relativeTo.empty()) {
    const std::optional<Scope::ResolvedFrame> frame = scope.findOrComplain(
        draft.pose.relativeTo, "the pose of particle_emitter '" + emitter.name + "' is relative to",
        draft.pose.position, context);
    if (frame) emitter.X_LinkEmitter = X_ScopeLink.inverse() * frame->X_ScopeFrame * draft.pose.value;
  }
  return emitter;
}

void addSystemEmitters(description::Model& model, const std::string& label, Context& context) {
  const auto link = std::ranges::find(model.links, model.canonicalLink, &description::Link::name);
  for (const description::Plugin& plugin : model.plugins) {
    if (!describesEmitter(plugin)) continue;
    if (link == model.links.end()) {
      context.diagnostics.warning(plugin.sdf.position,
                                  "particle-emitter of " + label + " emits nothing: its model has no link of its own");
      return;
    }
    EmitterDraft draft = readEmitter(emitterOf(plugin.sdf, label, context), label, context);
    if (std::ranges::find(link->emitters, draft.emitter.name, &description::ParticleEmitter::name) !=
        link->emitters.end()) {
      context.diagnostics.warning(plugin.sdf.position, "particle-emitter of " + label + " is left out: there is a '" +
                                                           draft.emitter.name + "' already");
      continue;
    }
    draft.emitter.X_LinkEmitter = link->X_ModelLink.inverse() * draft.pose.value;
    link->emitters.push_back(std::move(draft.emitter));
  }
}

}  // namespace pongsim::sdf
