#include "sdf/readers/models/emitter_reader.hh"

#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

using description::ParticleEmitter;

/// @param inModel Content of a model "m" at (1, 2, 3), whose link "l" is at (0, 0, 1) in it.
Loaded emitterWorld(const std::string& inLink, const std::string& inModel = "") {
  return loadWorld("<model name='m'><pose>1 2 3 0 0 0</pose><link name='l'><pose>0 0 1 0 0 0</pose>" + inLink +
                   "</link>" + inModel + "</model>");
}

std::vector<ParticleEmitter> emittersOf(const Loaded& loaded) {
  EXPECT_EQ(loaded.messages, Messages());
  return loaded.world().models.at(0).links.at(0).emitters;
}

TEST(ParticleEmitterReader, HasTheDefaultsOfTheFormat) {
  const ParticleEmitter emitter = emittersOf(emitterWorld("<particle_emitter name='e' type='point'/>")).at(0);
  EXPECT_EQ(emitter.name, "e");
  EXPECT_EQ(emitter.type, ParticleEmitter::Type::kPoint);
  EXPECT_TRUE(emitter.isEmitting);
  EXPECT_EQ(emitter.rate, 10);
  EXPECT_EQ(emitter.lifetime, 5);
  EXPECT_EQ(emitter.scaleRate, 0);
  EXPECT_EQ(emitter.scatterRatio, 0.65);
  EXPECT_EQ(emitter.colorStart, (description::Color{1, 1, 1, 1}));
}

TEST(ParticleEmitterReader, ReadsAll) {
  const ParticleEmitter emitter =
      emittersOf(emitterWorld("<particle_emitter name='e' type='ellipsoid'><pose>1 0 0 0 0 0</pose><size>1 2 3</size>"
                              "<rate>7</rate><duration>8</duration><emitting>false</emitting>"
                              "<particle_size>0.1 0.2 0.3</particle_size><lifetime>9</lifetime>"
                              "<min_velocity>0.5</min_velocity><max_velocity>0.75</max_velocity>"
                              "<color_start>1 0 0 1</color_start><color_end>0 1 0 0</color_end>"
                              "<scale_rate>0.25</scale_rate><topic>/puff</topic>"
                              "<particle_scatter_ratio>0.125</particle_scatter_ratio>"
                              "<material><diffuse>0.5 0.5 0.5 1</diffuse></material></particle_emitter>"))
          .at(0);
  EXPECT_EQ(emitter.type, ParticleEmitter::Type::kEllipsoid);
  expectPose(emitter.X_LinkEmitter, {1, 0, 0});
  EXPECT_EQ(emitter.size, Vector3(1, 2, 3));
  EXPECT_EQ(emitter.rate, 7);
  EXPECT_EQ(emitter.duration, 8);
  EXPECT_FALSE(emitter.isEmitting);
  EXPECT_EQ(emitter.particleSize, Vector3(0.1, 0.2, 0.3));
  EXPECT_EQ(emitter.lifetime, 9);
  EXPECT_EQ(emitter.minVelocity, 0.5);
  EXPECT_EQ(emitter.maxVelocity, 0.75);
  EXPECT_EQ(emitter.colorStart, (description::Color{1, 0, 0, 1}));
  EXPECT_EQ(emitter.colorEnd, (description::Color{0, 1, 0, 0}));
  EXPECT_EQ(emitter.scaleRate, 0.25);
  EXPECT_EQ(emitter.topic, "/puff");
  EXPECT_EQ(emitter.scatterRatio, 0.125);
  ASSERT_TRUE(emitter.material);
  EXPECT_EQ(emitter.material->diffuse.red, 0.5F);
}

TEST(ParticleEmitterReader, ResolvesThePose) {
  const ParticleEmitter emitter =
      emittersOf(emitterWorld("<particle_emitter name='e' type='point'>"
                              "<pose relative_to='__model__'>5 0 0 0 0 0</pose></particle_emitter>"))
          .at(0);
  expectPose(emitter.X_LinkEmitter, {5, 0, -1});
}

TEST(ParticleEmitterReader, LetsOneWithInvalidNumbersEmitNothing) {
  const Loaded loaded = emitterWorld("<particle_emitter name='e' type='box'><rate>-1</rate></particle_emitter>");
  ASSERT_EQ(loaded.messages.size(), 1U);
  EXPECT_NE(loaded.messages[0].find("particle_emitter 'e' of link 'l' of model 'm' emits nothing: its <rate> is not "
                                    "between 0 and 1e6"),
            std::string::npos)
      << loaded.messages[0];
  EXPECT_FALSE(loaded.world().models.at(0).links.at(0).emitters.at(0).isEmitting);
}

std::string emitterSystem(const std::string& content) {
  return "<plugin filename='ignition-gazebo-particle-emitter-system' "
         "name='ignition::gazebo::systems::ParticleEmitter'>" +
         content + "</plugin>";
}

TEST(ParticleEmitterReader, TakesTheSystemOfAModelForAnEmitterOfItsCanonicalLink) {
  const ParticleEmitter emitter =
      emittersOf(emitterWorld("", emitterSystem("<emitter_name>smoke</emitter_name><type>box</type>"
                                                "<pose>0 1 0 0 0 0</pose><emitting>true</emitting><rate>3</rate>")))
          .at(0);
  EXPECT_EQ(emitter.name, "smoke");
  EXPECT_EQ(emitter.type, ParticleEmitter::Type::kBox);
  expectPose(emitter.X_LinkEmitter, {0, 1, -1});
  EXPECT_TRUE(emitter.isEmitting);
  EXPECT_EQ(emitter.rate, 3);
  // other defaults than those of the element
  const ParticleEmitter plain = emittersOf(emitterWorld("", emitterSystem(""))).at(0);
  EXPECT_EQ(plain.name, "particle_emitter_entity");
  EXPECT_FALSE(plain.isEmitting);
  EXPECT_EQ(plain.scaleRate, 1);
}

TEST(ParticleEmitterReader, WarnsOfASystemThatItCantUse) {
  const std::string named = emitterSystem("<emitter_name>e</emitter_name>");
  const Loaded twice = emitterWorld("", named + named);
  ASSERT_EQ(twice.messages.size(), 1U);
  EXPECT_NE(twice.messages[0].find("particle-emitter of model 'm' is left out: there is a 'e' already"),
            std::string::npos);
  const Loaded odd = emitterWorld("", emitterSystem("<type>torus</type>"));
  ASSERT_EQ(odd.messages.size(), 1U);
  EXPECT_NE(odd.messages[0].find("<type> is 'torus': point is used"), std::string::npos);
}

}  // namespace
}  // namespace pongsim::sdf::test
