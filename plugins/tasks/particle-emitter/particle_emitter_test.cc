#include <gtest/gtest.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/laserscan.pb.h>
#include <ignition/msgs/particle_emitter.pb.h>
#include <ignition/msgs/particle_emitter_v.pb.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/scene.hh"
#include "support/ask_service.hh"
#include "support/example_world.hh"
#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::particle_emitter_test {
namespace {

namespace im = ignition::msgs;
using test::RunningWorld;

constexpr const char* kCommand = "/model/chimney/link/link/particle_emitter/smoke/cmd";
constexpr std::size_t kBeams = 41;
/// Where the lidar of the example sees the wall.
constexpr double kWall = 7.9;

/// @return All emitters, as the service tells them.
im::ParticleEmitter_V emittersOf(RunningWorld& world) {
  im::ParticleEmitter_V reply;
  const std::string service = "/world/" + std::string(world.simulation().world().name()) + "/particle_emitters";
  const CallResult result = test::askService(world.simulation().transport(), service, im::Empty(), reply);
  EXPECT_EQ(result.error, "");
  return reply;
}

/// The example: a lidar looks at a wall through smoke.
class ParticleEmitterTest : public testing::Test {
 protected:
  ParticleEmitterTest() {
    world_.listen("/scan", scans_);
    world_.step(4000);
  }

  static std::string content() {
    const std::string models = test::modelsOf("plugins/tasks/particle-emitter/particle_emitter.sdf");
    const std::size_t camera = models.find("<sensor name=\"camera\"");
    const std::string end = "</sensor>";
    return "<plugin filename='ignition-gazebo-sensors-system' name='ignition::gazebo::systems::Sensors'/>"
           "<plugin filename='ignition-gazebo-particle-emitter2-system' "
           "name='ignition::gazebo::systems::ParticleEmitter2'/>" +
           std::string(models).erase(camera, models.find(end, camera) + end.size() - camera);
  }

  /// @return The beams of the last scan that did not come back from the wall.
  std::size_t scattered() const {
    const auto& ranges = scans_.back().ranges();
    return static_cast<std::size_t>(std::ranges::count_if(ranges, [](double range) { return range < kWall - 0.01; }));
  }
  std::vector<double> lastRanges() const { return {scans_.back().ranges().begin(), scans_.back().ranges().end()}; }

  void emit(bool does) {
    im::ParticleEmitter message;
    message.mutable_emitting()->set_data(does);
    world_.tell(kCommand, message);
  }

  RunningWorld world_{content()};
  std::vector<im::LaserScan> scans_;
};

TEST_F(ParticleEmitterTest, ScattersTheBeamsOfALidarUntilItIsStopped) {
  EXPECT_EQ(lastRanges().size(), kBeams);
  // the ratio is 0.5
  EXPECT_GT(scattered(), kBeams / 5);
  EXPECT_LT(scattered(), kBeams * 4 / 5);
  emit(false);
  world_.step(4200);
  EXPECT_EQ(scattered(), 0U);
  emit(true);
  world_.step(3000);
  EXPECT_GT(scattered(), 0U);
}

TEST_F(ParticleEmitterTest, GivesTheSameBitsAfterAResetAndFromASave) {
  const std::vector<double> first = lastRanges();
  emit(false);
  world_.step(500);
  const std::vector<std::byte> state = world_.simulation().saveState();
  world_.step(500);
  const std::vector<double> later = lastRanges();
  EXPECT_NE(later, first);

  emit(true);
  world_.step(700);
  const Outcome<void> restored = world_.simulation().restoreState(state);
  ASSERT_TRUE(restored) << restored.error;
  world_.step(500);
  EXPECT_EQ(lastRanges(), later);

  Diagnostics diagnostics;
  world_.simulation().reset(diagnostics);
  world_.step(4000);
  EXPECT_EQ(lastRanges(), first);
}

TEST_F(ParticleEmitterTest, TellsOfAllEmitters) {
  const im::ParticleEmitter_V reply = emittersOf(world_);
  ASSERT_EQ(reply.particle_emitter_size(), 1);
  const im::ParticleEmitter& emitter = reply.particle_emitter(0);
  EXPECT_EQ(emitter.name(), "smoke");
  EXPECT_EQ(emitter.type(), im::ParticleEmitter::BOX);
  EXPECT_EQ(emitter.rate().data(), 20);
  EXPECT_EQ(emitter.header().data(0).value(0), kCommand);
  EXPECT_EQ(emitter.header().data(1).value(0), "chimney::link");
}

TEST_F(ParticleEmitterTest, RefusesWhatIsInvalid) {
  im::ParticleEmitter message;
  message.mutable_rate()->set_data(-3);
  testing::internal::CaptureStderr();
  world_.tell(kCommand, message);
  world_.step(1);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("its <rate> is not between 0 and 1e6"), std::string::npos);
  world_.tellAbsurdities(kCommand, "ignition.msgs.ParticleEmitter", "size {x: #}");
}

TEST_F(ParticleEmitterTest, ComesAndGoesWithItsModel) {
  const std::optional<Model> chimney = world_.simulation().world().model("chimney");
  ASSERT_TRUE(world_.simulation().remove(*chimney));
  world_.step(300);
  EXPECT_EQ(scattered(), 0U);
  EXPECT_EQ(emittersOf(world_).particle_emitter_size(), 0);

  Diagnostics diagnostics;
  ASSERT_TRUE(world_.simulation().insertText(
      "<sdf version='1.9'><model name='fog'><static>true</static><link name='l'><particle_emitter name='e' "
      "type='point'><topic>/puff</topic></particle_emitter></link></model></sdf>",
      "fog", {}, diagnostics));
  world_.step(1);
  im::ParticleEmitter message;
  message.mutable_rate()->set_data(99);
  world_.tell("/puff", message);
  world_.step(1);
  const im::ParticleEmitter_V reply = emittersOf(world_);
  ASSERT_EQ(reply.particle_emitter_size(), 1);
  EXPECT_EQ(reply.particle_emitter(0).rate().data(), 99);
}

TEST(ParticleEmitterSystem, ChangesTheEmitterThatItDescribes) {
  RunningWorld world(std::string(
      "<plugin filename='ignition-gazebo-particle-emitter2-system' "
      "name='ignition::gazebo::systems::ParticleEmitter2'/>"
      "<model name='m'><static>true</static><link name='l'/>"
      "<plugin filename='ignition-gazebo-particle-emitter-system' name='ignition::gazebo::systems::ParticleEmitter'>"
      "<emitter_name>e</emitter_name><rate>5</rate></plugin></model>"));
  im::ParticleEmitter message;
  message.mutable_rate()->set_data(7);
  world.step(1);
  world.tell("/model/m/particle_emitter/e", message);
  world.step(1);
  const im::ParticleEmitter_V reply = emittersOf(world);
  ASSERT_EQ(reply.particle_emitter_size(), 1);
  EXPECT_EQ(reply.particle_emitter(0).rate().data(), 7);
  EXPECT_FALSE(reply.particle_emitter(0).emitting().data());
  EXPECT_EQ(reply.particle_emitter(0).scale_rate().data(), 1);
}

TEST(ParticleEmitterSystem, RunsFortresssWorlds) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress";
  RunningWorld world(*worlds / "test/particle_emitter2.sdf");
  const im::ParticleEmitter_V emitters = emittersOf(world);
  ASSERT_EQ(emitters.particle_emitter_size(), 2);
  const im::ParticleEmitter& smoke = emitters.particle_emitter(0);
  EXPECT_EQ(smoke.name(), "smoke_emitter");
  EXPECT_EQ(smoke.type(), im::ParticleEmitter::BOX);
  EXPECT_EQ(smoke.pose().position().y(), 1);
  EXPECT_EQ(smoke.size().z(), 2);
  EXPECT_EQ(smoke.duration().data(), 1);
  EXPECT_EQ(smoke.max_velocity().data(), 20);
  EXPECT_EQ(smoke.color_start().b(), 1);
  EXPECT_EQ(smoke.color_range_image().data(), "/path/to/dummy_image.png");
  EXPECT_EQ(smoke.particle_scatter_ratio().data(), 0.01F);
  EXPECT_EQ(smoke.header().data(0).value(0),
            "/model/smoke_generator_demo_model/link/link/particle_emitter/smoke_emitter/cmd");
  EXPECT_EQ(emitters.particle_emitter(1).name(), "particle_emitter_entity");
  EXPECT_FALSE(emitters.particle_emitter(1).emitting().data());

  RunningWorld first(*worlds / "test/particle_emitter.sdf");
  first.step(100);
  const auto isEmitting = [&first] {
    const Scene scene(first.simulation().world());
    im::ParticleEmitter now;
    scene.fillInEmitter(scene.emitters().at(0).id, now);
    return now.emitting().data();
  };
  EXPECT_TRUE(isEmitting());
  im::ParticleEmitter off;
  off.mutable_emitting()->set_data(false);
  first.tell("/model/smoke_generator_demo_model/particle_emitter/smoke_emitter", off);
  first.step(100);
  EXPECT_FALSE(isEmitting());
}

}  // namespace
}  // namespace pongsim::particle_emitter_test
