#include "world/particles.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pongsim::world {
namespace {

using namespace std::chrono_literals;
using EmitterType = description::ParticleEmitter::Type;

/// A world with a model whose link has one emitter, in steps of 10 ms.
class ParticlesTest : public testing::Test {
 protected:
  ParticlesTest() {
    description::Model& model = world_.models.emplace_back();
    model.name = "m";
    model.canonicalLink = "l";
    description::Link& link = model.links.emplace_back();
    link.name = "l";
    emitter_ = &link.emitters.emplace_back();
    emitter_->name = "e";
  }

  void start(std::uint64_t seed = 1) {
    entities_.emplace(world_);
    state_.emplace(*entities_);
    particles_.emplace();
    particles_->setSeed(seed);
    particles_->follow(*entities_, 0);
  }
  void step(int count) {
    for (int i = 0; i < count; ++i) {
      state_->time += 10ms;
      particles_->advance(*entities_, *state_, 0.01);
    }
  }
  Emitter& emitter() { return particles_->emitters().at(0); }
  std::vector<Vector3> places() {
    std::vector<Vector3> all;
    for (const Particle& particle : emitter().particles) all.push_back(placed(emitter(), particle, state_->time).place);
    return all;
  }
  /// @return Where particles have begun, in the frame of the emitter at the origin.
  std::vector<Vector3> beginnings(EmitterType type) {
    emitter_->type = type;
    emitter_->size = {2, 4, 6};
    emitter_->rate = 1000;
    start();
    step(100);
    std::vector<Vector3> all;
    for (const Particle& particle : emitter().particles) all.push_back(particle.start);
    EXPECT_EQ(all.size(), 1000U);
    return all;
  }

  description::World world_;
  description::ParticleEmitter* emitter_ = nullptr;
  std::optional<Entities> entities_;
  std::optional<State> state_;
  std::optional<Particles> particles_;
};

TEST_F(ParticlesTest, AreEmittedAtTheRateAndDie) {
  emitter_->rate = 25;
  emitter_->lifetime = 2;
  start();
  step(100);
  EXPECT_EQ(emitter().particles.size(), 25U);
  step(400);
  EXPECT_EQ(emitter().particles.size(), 50U);
  EXPECT_EQ(emitter().count, 125U);
}

TEST_F(ParticlesTest, FlyAlongXOfTheEmitterWithinItsSpeeds) {
  emitter_->X_LinkEmitter = {{1, 2, 3}, fromRollPitchYaw(0, 0, 1.5707963267948966)};
  emitter_->minVelocity = 1;
  emitter_->maxVelocity = 3;
  emitter_->rate = 100;
  start();
  step(100);
  double slowest = 9, fastest = 0;
  for (const Particle& particle : emitter().particles) {
    EXPECT_TRUE(particle.start.isApprox(Vector3(1, 2, 3)));
    EXPECT_NEAR(particle.velocity.x(), 0, 1e-12);
    slowest = std::min(slowest, particle.velocity.y());
    fastest = std::max(fastest, particle.velocity.y());
  }
  EXPECT_GE(slowest, 1);
  EXPECT_LT(slowest, 1.2);
  EXPECT_LE(fastest, 3);
  EXPECT_GT(fastest, 2.8);
}

TEST_F(ParticlesTest, GrowAndKnowTheShareOfTheirLife) {
  emitter_->rate = 100;
  emitter_->minVelocity = emitter_->maxVelocity = 2;
  emitter_->scaleRate = 0.5;
  emitter_->particleSize = {1, 3, 1};
  start();
  step(1);
  const Particle particle = emitter().particles.at(0);
  const PlacedParticle later = placed(emitter(), particle, particle.born + 2s);
  EXPECT_NEAR(later.place.x(), 4, 1e-12);
  EXPECT_NEAR(later.width, 2, 1e-12);
  EXPECT_NEAR(later.height, 4, 1e-12);
  EXPECT_NEAR(later.share, 0.4, 1e-12);
}

TEST_F(ParticlesTest, BeginInTheVolume) {
  for (const Vector3& place : beginnings(EmitterType::kPoint)) EXPECT_EQ(place, Vector3::Zero());
  // the first size is along y, the second along z, the third along x
  Eigen::AlignedBox3d box;
  for (const Vector3& place : beginnings(EmitterType::kBox)) box.extend(place);
  EXPECT_TRUE(Eigen::AlignedBox3d(Vector3(-3, -1, -2), Vector3(3, 1, 2)).contains(box));
  EXPECT_GT(box.sizes().x(), 5.5);
  EXPECT_GT(box.sizes().y(), 1.8);
  EXPECT_GT(box.sizes().z(), 3.6);
  for (const Vector3& place : beginnings(EmitterType::kCylinder)) {
    EXPECT_LE(place.y() * place.y() + place.z() * place.z() / 4, 1);
  }
  for (const Vector3& place : beginnings(EmitterType::kEllipsoid)) {
    EXPECT_LE(place.cwiseQuotient(Vector3(3, 1, 2)).squaredNorm(), 1);
  }
}

TEST_F(ParticlesTest, StopAfterTheDuration) {
  emitter_->rate = 12.5;
  emitter_->duration = 1;
  start();
  step(300);
  EXPECT_EQ(emitter().count, 12U);
  emitter().since = state_->time;
  step(300);
  EXPECT_EQ(emitter().count, 25U);
}

TEST_F(ParticlesTest, StayWhereTheyWereEmittedWhenTheLinkMoves) {
  emitter_->rate = 12.5;
  emitter_->minVelocity = emitter_->maxVelocity = 0;
  start();
  step(8);
  state_->links[0].X_WorldLink.position = {5, 0, 0};
  step(8);
  const std::vector<Vector3> found = places();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0], Vector3(0, 0, 0));
  EXPECT_EQ(found[1], Vector3(5, 0, 0));
}

TEST_F(ParticlesTest, DependOnTheSeedAlone) {
  emitter_->type = EmitterType::kBox;
  emitter_->rate = 100;
  const auto run = [this](std::uint64_t seed) {
    start(seed);
    step(100);
    return places();
  };
  EXPECT_EQ(run(1), run(1));
  EXPECT_NE(run(1), run(2));
}

TEST_F(ParticlesTest, AreNoMoreThanTheMost) {
  emitter_->rate = 1e6;
  emitter_->lifetime = 1e6;
  start();
  step(10);
  EXPECT_EQ(emitter().particles.size(), Particles::kMost);
}

TEST_F(ParticlesTest, ContinueFromASavedStateWithTheSameBits) {
  emitter_->type = EmitterType::kBox;
  emitter_->rate = 33;
  emitter_->lifetime = 0.5;
  start();
  step(77);
  StateArchive taken;
  particles_->transfer(taken);
  const std::vector<std::byte> bytes = taken.take();
  const Time time = state_->time;
  step(50);
  const std::vector<Vector3> expected = places();
  start();
  StateArchive given(bytes);
  particles_->transfer(given);
  state_->time = time;
  step(50);
  EXPECT_EQ(places(), expected);
}

TEST_F(ParticlesTest, GoWithTheirLink) {
  start();
  step(100);
  const EmitterId id = emitter().id;
  EXPECT_NE(particles_->find(id), nullptr);
  entities_->removeModels({0});
  particles_->follow(*entities_, 1);
  EXPECT_EQ(particles_->find(id), nullptr);
}

TEST_F(ParticlesTest, WaitWhileTheirLinkIsSetAside) {
  emitter_->rate = 12.5;
  start();
  step(100);
  entities_->setAside({entities_->models()[0].id.value});
  particles_->follow(*entities_, 1);
  step(100);
  EXPECT_EQ(emitter().count, 12U);
  entities_->setAside({});
  particles_->follow(*entities_, 2);
  step(100);
  EXPECT_EQ(emitter().count, 25U);
}

}  // namespace
}  // namespace pongsim::world
