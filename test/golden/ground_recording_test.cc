// Compares vehicles on wheels and belts with the recordings of Fortress's server.

#include <gtest/gtest.h>

#include "golden/recording.hh"

namespace pongsim::test {
namespace {

TEST(GroundRecording, MecanumWheelsDriveDiagonally) {
  if (!Replay::isHere()) GTEST_SKIP() << "Fortress's worlds or recordings are not here";
  Replay replay("examples/mecanum_drive.sdf",
                {{Time(0), "/model/vehicle_blue/cmd_vel", "ignition.msgs.Twist", "linear: {x: 0.5, y: 0.5}"}});
  replay.run();
  EXPECT_TRUE(replay.missing().empty());
  const Deviation& vehicle = replay.of("model vehicle_blue");
  EXPECT_GT(vehicle.way, 3.4);
  EXPECT_LT(vehicle.largest, 0.02 * vehicle.way);
  EXPECT_LT(vehicle.largestAngle, 0.01);
}

/// Compares a crate's fall onto a belt at rest. In the recordings the belts do not move, because the DART of the
/// recorded server lacks the moving surfaces of the Fortress project's own. The motion on a moving belt is compared
/// with mechanics below and in the tests of the physics.
void expectFallLike(const std::string& world) {
  Replay replay(world);
  replay.run();
  EXPECT_TRUE(replay.missing().empty());
  EXPECT_LT(replay.of("model box").largest, 0.05);
  EXPECT_LT(replay.of("model box").largestAngle, 1e-3);
}

TEST(GroundRecording, CratesFallOnBeltsThatStand) {
  if (!Replay::isHere()) GTEST_SKIP() << "Fortress's worlds or recordings are not here";
  expectFallLike("examples/conveyor.sdf");
  expectFallLike("test/conveyor.sdf");
}

// The positions are those of Fortress's own test of this world, which allows 0.1 m.
TEST(GroundRecording, ABeltCarriesACrateAsFortressTestsIt) {
  if (!Replay::isHere()) GTEST_SKIP() << "Fortress's worlds or recordings are not here";
  Replay replay("test/conveyor.sdf");
  Simulation& simulation = replay.simulation();
  simulation.step(1000);
  const Publisher command = [&] {
    Publisher publisher =
        simulation.transport().node().advertise("/model/conveyor/link/base_link/track_cmd_vel", "ignition.msgs.Double");
    const MessagePointer message = newMessage("ignition.msgs.Double");
    EXPECT_FALSE(parseMessage("data: 1", *message));
    publisher.publish(*message);
    return publisher;
  }();
  const Model box = simulation.world().model("box").value();
  // 0.25 m/s^2 up to 0.5 m/s; after two seconds the command expires, and the belt decelerates at the same rate
  for (const double way : {0.125, 0.5, 0.875}) {
    simulation.step(1000);
    EXPECT_NEAR(box.pose().position.x(), way, 0.01 * way);
    EXPECT_NEAR(box.pose().position.y(), 0, 1e-3);
  }
}

TEST(GroundRecording, ATireLiesOnItsDrum) {
  if (!Replay::isHere()) GTEST_SKIP() << "Fortress's worlds or recordings are not here";
  Replay replay("test/tire_drum.sdf");
  replay.run();
  EXPECT_LT(replay.of("link tire::wheel").largest, 0.01);
  EXPECT_LT(replay.of("link drum::link").largest, 0.01);
}

}  // namespace
}  // namespace pongsim::test
