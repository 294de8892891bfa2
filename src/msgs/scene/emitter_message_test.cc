#include "msgs/scene/emitter_message.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/particle_emitter.pb.h>

namespace pongsim::msgs {
namespace {

namespace im = ignition::msgs;

description::ParticleEmitter fog() {
  description::ParticleEmitter emitter;
  emitter.name = "fog";
  emitter.type = description::ParticleEmitter::Type::kCylinder;
  emitter.X_LinkEmitter.position = {1, 2, 3};
  emitter.size = {1, 2, 3};
  emitter.rate = 7.5;
  emitter.duration = 2;
  emitter.isEmitting = false;
  emitter.particleSize = {0.5, 0.25, 1};
  emitter.lifetime = 4;
  emitter.minVelocity = 0.5;
  emitter.maxVelocity = 1.5;
  emitter.colorStart = {1, 0, 0, 1};
  emitter.colorEnd = {0, 1, 0, 0.5F};
  emitter.scaleRate = 0.125;
  emitter.colorRange = {"colors.png", "/a/colors.png"};
  emitter.topic = "/fog";
  emitter.scatterRatio = 0.25;
  emitter.material.emplace().metal.emplace().maps.albedo = {"fog.png", "/a/fog.png"};
  return emitter;
}

TEST(EmitterMessage, MakesTheSameEmitterAgain) {
  im::ParticleEmitter message;
  setEmitter(fog(), 17, message);
  EXPECT_EQ(message.id(), 17U);
  EXPECT_EQ(message.type(), im::ParticleEmitter::CYLINDER);
  EXPECT_EQ(message.color_range_image().data(), "/a/colors.png");
  description::ParticleEmitter before = fog();
  before.rate = 1;
  before.isEmitting = true;
  before.size = {9, 9, 9};
  before.type = description::ParticleEmitter::Type::kPoint;
  description::ParticleEmitter again = changedEmitter(before, message);
  // a material's other values are those of the message
  again.material = fog().material;
  EXPECT_EQ(again, fog());
}

TEST(EmitterMessage, ChangesWhatItSets) {
  im::ParticleEmitter message;
  message.mutable_rate()->set_data(100);
  const description::ParticleEmitter changed = changedEmitter(fog(), message);
  EXPECT_EQ(changed.rate, 100);
  EXPECT_EQ(changed.type, fog().type);
  EXPECT_EQ(changed.lifetime, 4);
  EXPECT_FALSE(beginsEmission(message));
  message.mutable_emitting()->set_data(true);
  EXPECT_TRUE(beginsEmission(message));
}

TEST(EmitterMessage, KnowsNoOtherImages) {
  im::ParticleEmitter message;
  message.mutable_color_range_image()->set_data("/etc/picture.png");
  EXPECT_TRUE(changedEmitter(fog(), message).colorRange.file.empty());
  message.mutable_color_range_image()->set_data("colors.png");
  EXPECT_EQ(changedEmitter(fog(), message).colorRange, fog().colorRange);
}

TEST(EmitterMessage, CollectsChanges) {
  std::string changes;
  im::ParticleEmitter first, second;
  first.mutable_rate()->set_data(100);
  first.mutable_emitting()->set_data(true);
  mergeEmitter(first, changes);
  second.mutable_emitting()->set_data(false);
  mergeEmitter(second, changes);
  const auto after = emitterAfter(fog(), changes);
  ASSERT_TRUE(after);
  EXPECT_EQ(after->rate, 100);
  EXPECT_FALSE(after->isEmitting);
  EXPECT_FALSE(emitterAfter(fog(), "\xff\xff"));
}

}  // namespace
}  // namespace pongsim::msgs
