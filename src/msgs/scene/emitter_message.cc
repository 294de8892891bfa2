#include "msgs/scene/emitter_message.hh"

#include <ignition/msgs/particle_emitter.pb.h>

#include <initializer_list>
#include <vector>

#include "msgs/scene/color_message.hh"
#include "msgs/scene/full_path.hh"
#include "msgs/scene/material_message.hh"
#include "msgs/scene/pose_message.hh"
#include "pongsim/messages/fields.hh"

namespace pongsim::msgs {

namespace {

using description::ParticleEmitter;
using Wire = ignition::msgs::ParticleEmitter;

Wire::EmitterType wireType(ParticleEmitter::Type type) {
  using enum ParticleEmitter::Type;
  return type == kBox         ? Wire::BOX
         : type == kCylinder  ? Wire::CYLINDER
         : type == kEllipsoid ? Wire::ELLIPSOID
                              : Wire::POINT;
}

/// @return The image with its file, if it is one of `known`.
description::Texture knownImage(description::Texture image, std::initializer_list<const description::Texture*> known) {
  for (const description::Texture* each : known) {
    if (!image.uri.empty() && (image.uri == each->uri || image.uri == pathOf(*each))) return *each;
  }
  return image;
}

description::Texture albedoOf(const std::optional<description::Material>& material) {
  if (!material) return {};
  return material->metal   ? material->metal->maps.albedo
         : material->gloss ? material->gloss->maps.albedo
                           : description::Texture();
}

description::Material knownMaterial(description::Material material,
                                    const std::optional<description::Material>& before) {
  const description::Texture albedo = albedoOf(before);
  if (material.metal) material.metal->maps.albedo = knownImage(material.metal->maps.albedo, {&albedo});
  if (material.gloss) material.gloss->maps.albedo = knownImage(material.gloss->maps.albedo, {&albedo});
  return material;
}

void setFloat(double value, ignition::msgs::Float& message) { message.set_data(static_cast<float>(value)); }

}  // namespace

void setEmitter(const ParticleEmitter& emitter, std::uint64_t id, Message& given) {
  auto& message = static_cast<Wire&>(given);
  message.set_id(static_cast<std::uint32_t>(id));
  message.set_name(emitter.name);
  message.set_type(wireType(emitter.type));
  setPose(emitter.X_LinkEmitter, *message.mutable_pose());
  setVector(emitter.size, *message.mutable_size());
  setVector(emitter.particleSize, *message.mutable_particle_size());
  setFloat(emitter.rate, *message.mutable_rate());
  setFloat(emitter.duration, *message.mutable_duration());
  message.mutable_emitting()->set_data(emitter.isEmitting);
  setFloat(emitter.lifetime, *message.mutable_lifetime());
  if (emitter.material) setMaterial(*emitter.material, *message.mutable_material());
  setFloat(emitter.minVelocity, *message.mutable_min_velocity());
  setFloat(emitter.maxVelocity, *message.mutable_max_velocity());
  setColor(emitter.colorStart, *message.mutable_color_start());
  setColor(emitter.colorEnd, *message.mutable_color_end());
  setFloat(emitter.scaleRate, *message.mutable_scale_rate());
  message.mutable_color_range_image()->set_data(pathOf(emitter.colorRange));
  message.mutable_topic()->set_data(emitter.topic);
  setFloat(emitter.scatterRatio, *message.mutable_particle_scatter_ratio());
}

bool beginsEmission(const Message& message) {
  const auto& given = static_cast<const Wire&>(message);
  return given.has_emitting() || given.has_duration();
}

ParticleEmitter changedEmitter(const ParticleEmitter& before, const Message& given) {
  const auto& message = static_cast<const Wire&>(given);
  ParticleEmitter after = before;
  using enum ParticleEmitter::Type;
  if (message.type() == Wire::BOX) after.type = kBox;
  if (message.type() == Wire::CYLINDER) after.type = kCylinder;
  if (message.type() == Wire::ELLIPSOID) after.type = kEllipsoid;
  if (message.has_size()) after.size = vectorFrom(message.size());
  if (message.has_particle_size()) after.particleSize = vectorFrom(message.particle_size());
  const auto take = [](bool isSet, const ignition::msgs::Float& value, double& to) {
    if (isSet) to = static_cast<double>(value.data());
  };
  take(message.has_rate(), message.rate(), after.rate);
  take(message.has_duration(), message.duration(), after.duration);
  take(message.has_lifetime(), message.lifetime(), after.lifetime);
  take(message.has_min_velocity(), message.min_velocity(), after.minVelocity);
  take(message.has_max_velocity(), message.max_velocity(), after.maxVelocity);
  take(message.has_scale_rate(), message.scale_rate(), after.scaleRate);
  take(message.has_particle_scatter_ratio(), message.particle_scatter_ratio(), after.scatterRatio);
  if (message.has_emitting()) after.isEmitting = message.emitting().data();
  if (message.has_color_start()) after.colorStart = colorOf(message.color_start());
  if (message.has_color_end()) after.colorEnd = colorOf(message.color_end());
  if (message.has_color_range_image()) {
    after.colorRange = knownImage({message.color_range_image().data(), {}}, {&before.colorRange});
  }
  if (message.has_material()) after.material = knownMaterial(materialFrom(message.material()), before.material);
  return after;
}

void mergeEmitter(const Message& message, std::string& changes) {
  Wire all;
  all.ParseFromString(changes);
  const auto& given = static_cast<const Wire&>(message);
  // what is in it is replaced as a whole: merging would not tell that something is false or zero now
  std::vector<const google::protobuf::FieldDescriptor*> fields;
  given.GetReflection()->ListFields(given, &fields);
  for (const google::protobuf::FieldDescriptor* field : fields) all.GetReflection()->ClearField(&all, field);
  all.MergeFrom(given);
  // neither has an effect, and what is not known would be added each time
  all.clear_header();
  all.DiscardUnknownFields();
  changes = all.SerializeAsString();
}

std::optional<ParticleEmitter> emitterAfter(const ParticleEmitter& before, const std::string& changes) {
  Wire all;
  if (!all.ParseFromString(changes)) return std::nullopt;
  return changedEmitter(before, all);
}

}  // namespace pongsim::msgs
