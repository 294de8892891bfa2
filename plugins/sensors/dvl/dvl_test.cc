#include <gtest/gtest.h>
#include <ignition/msgs/dvl_velocity_tracking.pb.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "support/running_world.hh"
#include "support/temp_folder.hh"

namespace pongsim::dvl_test {
namespace {

using ignition::msgs::DVLTrackingTarget;
using ignition::msgs::DVLVelocityTracking;
using test::RunningWorld;

/// cos(30 degrees): of the beams' tilt.
const double kTiltCosine = std::sqrt(0.75);

std::string noise(double deviation) {
  return "<noise type='gaussian'><stddev>" + std::to_string(deviation) + "</stddev></noise>";
}

/// Four beams, tilted by 30 degrees, each of one ray.
std::string dvl(const std::string& modes, const std::string& more = "") {
  std::string beams;
  for (const char* rotation : {"45", "135", "-45", "-135"}) {
    beams += "<beam><aperture>1</aperture><rotation>" + std::string(rotation) + "</rotation><tilt>30</tilt></beam>";
  }
  return "<gz:dvl><type>phased_array</type><arrangement degrees='true'>" + beams + "</arrangement><tracking>" + modes +
         "</tracking>" + more + "</gz:dvl>";
}

std::string bottom(const std::string& content = "") { return "<bottom_mode>" + content + "</bottom_mode>"; }

std::string water(const std::string& content = "") {
  return "<water_mass_mode><water_velocity><x>east</x><y>north</y></water_velocity>" + content + "</water_mass_mode>";
}

/// A sensor at the origin, in a model that drives.
std::string worldWith(const std::string& content, const std::string& sensor, const std::string& pose = "0 0 0 0 0 0") {
  return "<gravity>0 0 0</gravity>"
         "<plugin filename='gz-sim-dvl-system' name='gz::sim::systems::DopplerVelocityLogSystem'/>"
         "<model name='m'><pose>" +
         pose +
         "</pose><link name='l'><inertial><mass>1</mass></inertial><sensor name='s' type='custom' gz:type='dvl'>" +
         sensor + "</sensor></link></model>" + content;
}

/// @return A plate whose top is at this height.
std::string plate(double top) {
  return "<model name='plate'><pose>0 0 " + std::to_string(top - 0.5) +
         " 0 0 0</pose><link name='l'><inertial><mass>1</mass></inertial><visual name='v'><geometry><box>"
         "<size>1000 1000 1</size></box></geometry></visual></link></model>";
}

Vector3 velocityOf(const DVLVelocityTracking& message) {
  const auto& mean = message.velocity().mean();
  return {mean.x(), mean.y(), mean.z()};
}

class DvlTest : public testing::Test {
 protected:
  /// A current of (0.5, -0.25, 0) m/s everywhere.
  std::string current() const {
    const std::string file = (folder_.path() / "current.csv").string();
    std::ofstream csv(file);
    csv << "t,x,y,z,east,north\n";
    for (const int x : {-1000, 1000}) {
      for (const int y : {-1000, 1000}) {
        for (const int z : {-1000, 1000}) csv << "0," << x << "," << y << "," << z << ",0.5,-0.25\n";
      }
    }
    return "<plugin filename='gz-sim-environment-preload-system' name='gz::sim::systems::EnvironmentPreload'><data>" +
           file + "</data><dimensions><ignore_time>true</ignore_time></dimensions></plugin>";
  }

  /// @return The messages of a step.
  static std::vector<DVLVelocityTracking> measure(const std::string& content, const Vector3& velocity,
                                                  const Vector3& ofPlate = Vector3::Zero()) {
    RunningWorld world(content);
    world.model("m").setVelocity(velocity, Vector3::Zero());
    if (const auto plate = world.simulation().world().model("plate")) {
      Model(*plate).setVelocity(ofPlate, Vector3::Zero());
    }
    std::vector<DVLVelocityTracking> messages;
    world.listen("/world/w/model/m/link/l/sensor/s/dvl/velocity", messages);
    world.step(1);
    return messages;
  }

  static DVLVelocityTracking one(const std::vector<DVLVelocityTracking>& messages) {
    EXPECT_EQ(messages.size(), 1U);
    return messages.at(0);
  }

  test::TempFolder folder_;
};

TEST_F(DvlTest, TracksTheBottom) {
  const DVLVelocityTracking message = one(measure(worldWith(plate(-20), dvl(bottom())), {1, -0.5, 0}));
  EXPECT_EQ(message.type(), DVLVelocityTracking::DVL_TYPE_PHASED_ARRAY);
  EXPECT_EQ(message.header().data(0).value(0), "m::l::s");
  EXPECT_TRUE(velocityOf(message).isApprox(Vector3(1, -0.5, 0), 1e-9)) << message.DebugString();
  EXPECT_EQ(message.target().type(), DVLTrackingTarget::DVL_TARGET_BOTTOM);
  EXPECT_NEAR(message.target().range().mean(), 20 / kTiltCosine, 1e-9);
  ASSERT_EQ(message.beams_size(), 4);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(message.beams(i).id(), i);
    EXPECT_TRUE(message.beams(i).locked());
    EXPECT_NEAR(message.beams(i).range().mean(), 20 / kTiltCosine, 1e-9);
  }
  // the first looks back and to the left: (-1, 1, -sqrt(6)) / sqrt(8), so s = -1.5 / sqrt(8)
  const auto& mean = message.beams(0).velocity().mean();
  EXPECT_NEAR(mean.x(), 1.5 / 8, 1e-9);
  EXPECT_NEAR(mean.y(), -1.5 / 8, 1e-9);
  EXPECT_NEAR(mean.z(), 1.5 / 8 * std::sqrt(6), 1e-9);
}

TEST_F(DvlTest, MeasuresRelativeToWhatABeamHits) {
  const DVLVelocityTracking message =
      one(measure(worldWith(plate(-20), dvl(bottom())), {1, -0.5, 0.25}, {0.25, 0.5, 0.125}));
  EXPECT_TRUE(velocityOf(message).isApprox(Vector3(0.75, -1, 0.125), 1e-9)) << message.DebugString();
}

TEST_F(DvlTest, MeasuresInItsReferenceFrame) {
  const std::string turned = "<reference_frame>0 0 0 0 0 -1.5707963267948966</reference_frame>";
  // turned by 30 degrees about the vertical itself
  const DVLVelocityTracking message =
      one(measure(worldWith(plate(-20), dvl(bottom(), turned), "0 0 0 0 0 0.5235987755982988"), {2, 0, 0.5}));
  EXPECT_TRUE(velocityOf(message).isApprox(Vector3(1, std::sqrt(3), 0.5), 1e-9)) << message.DebugString();
}

TEST_F(DvlTest, FindsTheNearestPointOfAWideBeam) {
  const std::string wide =
      "<gz:dvl><arrangement><beam><aperture>0.4</aperture><tilt>0.3</tilt></beam>"
      "<beam id='7'><aperture>0.4</aperture><tilt>0.5</tilt><rotation>2</rotation></beam>"
      "<beam><aperture>0.4</aperture><tilt>0.1</tilt><rotation>4</rotation></beam></arrangement>"
      "<resolution>0.005</resolution><tracking><bottom_mode/></tracking></gz:dvl>";
  const DVLVelocityTracking message = one(measure(worldWith(plate(-20), wide), {0, 0, 0}));
  EXPECT_NEAR(message.beams(0).range().mean(), 20 / std::cos(0.1), 0.02);
  EXPECT_NEAR(message.beams(1).range().mean(), 20 / std::cos(0.3), 0.05);
  EXPECT_NEAR(message.beams(2).range().mean(), 20, 0.001);
  EXPECT_EQ(message.beams(0).id(), 0);
  EXPECT_EQ(message.beams(1).id(), 7);
  EXPECT_EQ(message.beams(2).id(), 8);
}

/// As Gazebo's own test of a bottomless pit tells it.
TEST_F(DvlTest, TracksNothingWithoutABottom) {
  for (const double top : {-90.0, -0.05}) {
    // 90 m are 104 m along the beams, and 5 cm are closer than their least range
    const DVLVelocityTracking message = one(measure(worldWith(plate(top), dvl(bottom())), {1, 0, 0}));
    EXPECT_FALSE(message.has_target());
    EXPECT_FALSE(message.has_velocity());
    ASSERT_EQ(message.beams_size(), 4);
    for (const auto& beam : message.beams()) EXPECT_FALSE(beam.locked());
  }
}

TEST_F(DvlTest, TracksTheWater) {
  const std::string layer = "<boundaries><near>10</near><far>30</far></boundaries><bins>4</bins>";
  const DVLVelocityTracking message = one(measure(worldWith(current(), dvl(water(layer))), {1, 0, 0.5}));
  EXPECT_EQ(message.target().type(), DVLTrackingTarget::DVL_TARGET_WATER_MASS);
  EXPECT_TRUE(velocityOf(message).isApprox(Vector3(0.5, 0.25, 0.5), 1e-9)) << message.DebugString();
  EXPECT_NEAR(message.target().range().mean(), 20 / kTiltCosine, 1e-9);
  EXPECT_NEAR(message.target().range().variance(), 400 / 0.75 / 12, 1e-9);
  // what is within the layer is in the way
  const DVLVelocityTracking shallow = one(measure(worldWith(current() + plate(-29), dvl(water(layer))), {1, 0, 0}));
  EXPECT_FALSE(shallow.has_velocity());
  EXPECT_FALSE(shallow.beams(0).locked());
  const DVLVelocityTracking deep = one(measure(worldWith(current() + plate(-31), dvl(water(layer))), {1, 0, 0}));
  EXPECT_TRUE(deep.has_velocity());
}

TEST_F(DvlTest, PublishesWhatIsMoreCertain) {
  const auto types = [&](const std::string& ofBottom, const std::string& ofWater) {
    std::string text;
    for (const auto& message :
         measure(worldWith(current() + plate(-82), dvl(bottom(ofBottom) + water(ofWater))), {1, 0, 0})) {
      text += message.target().type() == DVLTrackingTarget::DVL_TARGET_BOTTOM ? "b" : "w";
    }
    return text;
  };
  const std::string best = "<when>best</when>";
  EXPECT_EQ(types(best + noise(0.1), best + noise(0.01)), "w");
  EXPECT_EQ(types(best + noise(0.01), best + noise(0.1)), "b");
  EXPECT_EQ(types("", ""), "bw");
  EXPECT_EQ(types("<when>never</when>", best), "w");
  EXPECT_EQ(types(noise(0.01), best + noise(0.1)), "b");
  EXPECT_EQ(types(noise(0.1), best + noise(0.01)), "bw");
}

TEST_F(DvlTest, HasNoiseAlongEachBeam) {
  RunningWorld world(worldWith(plate(-20), dvl(bottom(noise(0.02)))));
  std::vector<DVLVelocityTracking> messages;
  world.listen("/world/w/model/m/link/l/sensor/s/dvl/velocity", messages);
  world.step(2000);
  Vector3 squares = Vector3::Zero();
  for (const auto& message : messages) squares += velocityOf(message).cwiseAbs2() / 2000;
  // (B^T B)^-1 = diag(2, 2, 1/3)
  const Vector3 expected = 0.0004 * Vector3(2, 2, 1.0 / 3);
  EXPECT_TRUE(squares.isApprox(expected, 0.1)) << squares.transpose();
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(messages[0].velocity().covariance(4 * i), expected[i], 1e-9);
}

TEST_F(DvlTest, WarnsOnceOfWaterThatItDoesNotKnow) {
  RunningWorld world(worldWith("", dvl(water())));
  std::vector<DVLVelocityTracking> messages;
  world.listen("/world/w/model/m/link/l/sensor/s/dvl/velocity", messages);
  testing::internal::CaptureStderr();
  world.step(3);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("sensor 'm::l::s' can't track water: the world has no environment"), std::string::npos) << said;
  EXPECT_EQ(messages.size(), 3U);
}

TEST_F(DvlTest, SaysWhatIsWrongWithItsElements) {
  const auto said = [](const std::string& sensor) {
    const std::vector<std::string> all = RunningWorld::complaintsAbout(worldWith("", sensor));
    return all.size() == 1 ? all[0] : std::to_string(all.size()) + " messages";
  };
  const std::string out = ": it is left out";
  EXPECT_EQ(said(""), "a sensor of the type dvl needs a <gz:dvl>" + out);
  EXPECT_EQ(said("<gz:dvl/>"), "<gz:dvl> has no <arrangement>" + out);
  EXPECT_EQ(said("<gz:dvl><arrangement><beam/><beam/></arrangement></gz:dvl>"),
            "<arrangement> needs at least three <beam>s" + out);
  EXPECT_EQ(said("<gz:dvl><arrangement><beam/><beam/><beam/></arrangement></gz:dvl>"),
            "<gz:dvl> has no <tracking>" + out);
  EXPECT_EQ(said("<gz:dvl><arrangement><beam><tilt>1.6</tilt></beam></arrangement></gz:dvl>"),
            "<tilt> must be less than a quarter of a turn" + out);
  EXPECT_EQ(said("<gz:dvl><type>laser</type></gz:dvl>"), "<type> is 'laser'" + out);
  EXPECT_EQ(said(dvl(bottom("<when>often</when>"))), "<when> is 'often'" + out);
  EXPECT_EQ(said(dvl(water("<bins>0</bins>"))), "<bins> must be from 1 to 1000" + out);
  EXPECT_EQ(said(dvl(water("<boundaries><near>30</near><far>20</far></boundaries>"))),
            "<boundaries>: <near> must be below <far>, and that within the <maximum_range>" + out);
  EXPECT_EQ(said(dvl("<water_mass_mode/>")), "<water_mass_mode> has no <water_velocity>" + out);
  EXPECT_EQ(said(dvl(bottom(), "<resolution>0</resolution>")), "<resolution> must be above 0" + out);
  EXPECT_EQ(said(dvl(bottom(), "<resolution>1e-6</resolution>")), "sensor 'm::l::s' has more than 100000 rays" + out);
  EXPECT_EQ(said(dvl(bottom(), "<reference_frame>0 0 1</reference_frame>")),
            "<reference_frame> needs six numbers" + out);
}

}  // namespace
}  // namespace pongsim::dvl_test
