#include <gtest/gtest.h>
#include <ignition/msgs/double.pb.h>
#include <ignition/msgs/vector3d.pb.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "support/running_world.hh"
#include "support/temp_folder.hh"

namespace pongsim::environmental_sensor_test {
namespace {

using ignition::msgs::Double;
using test::RunningWorld;

constexpr const char* kTopic = "/world/w/model/m/link/l/sensor/s/environmental_sensor/humidity";

class EnvironmentalSensorTest : public testing::Test {
 protected:
  /// A table over -1 to 1 m along each axis, whose `humidity` is 10 x + 100 t + 1, and whose current is (1, 2, 3) m/s.
  /// The lines do not stand in any order.
  static std::string table() {
    std::ostringstream text;
    text << "time,humidity,u,v,w,x,y,z\n";
    for (const int time : {1, 0}) {
      for (const int x : {1, -1, 0}) {
        for (const int y : {-1, 1}) {
          for (const int z : {1, -1}) {
            text << time << "," << 10 * x + 100 * time + 1 << ", 1, 2, 3, " << x << ", " << y << ", " << z << "\n";
          }
        }
      }
    }
    return text.str();
  }

  std::string environment(const std::string& csv, const std::string& dimensions = "<time>time</time>") const {
    const std::string file = (folder_.path() / "data.csv").string();
    std::ofstream(file) << csv;
    return "<plugin filename='gz-sim-environment-preload-system' name='gz::sim::systems::EnvironmentPreload'><data>" +
           file + "</data><dimensions>" + dimensions + "</dimensions></plugin>";
  }

  static std::string world(const std::string& sensor, const std::string& type = "humidity",
                           const std::string& pose = "0 0 0 0 0 0") {
    return "<gravity>0 0 0</gravity>"
           "<plugin filename='gz-sim-environmental-sensor-system' name='gz::sim::systems::EnvironmentalSystem'/>"
           "<model name='m'><pose>" +
           pose +
           "</pose><link name='l'><inertial><mass>1</mass></inertial>"
           "<sensor name='s' type='custom' gz:type='environmental_sensor/" +
           type + "'>" + sensor + "</sensor></link></model>";
  }

  test::TempFolder folder_;
};

TEST_F(EnvironmentalSensorTest, InterpolatesInTimeAndSpace) {
  RunningWorld running(world("", "humidity", "0.25 0.5 -0.3 0 0 0") + environment(table()));
  std::vector<Double> heard;
  running.listen(kTopic, heard);
  running.step(999);
  ASSERT_EQ(heard.size(), 999U);
  EXPECT_NEAR(heard[0].data(), 2.5 + 0.1 + 1, 1e-9);
  EXPECT_NEAR(heard[498].data(), 2.5 + 49.9 + 1, 1e-9);
  EXPECT_EQ(heard[0].header().data(0).value(0), "m::l::s");
  // the table ends
  running.step(100);
  EXPECT_EQ(heard.size(), 1000U);
}

TEST_F(EnvironmentalSensorTest, ObservesRateTopicAndVariable) {
  RunningWorld running(
      world("<update_rate>100</update_rate><topic>/current</topic><environment_variable>v</environment_variable>",
            "anything") +
      environment(table()));
  std::vector<Double> heard;
  running.listen("/current", heard);
  running.step(100);
  ASSERT_EQ(heard.size(), 11U);
  EXPECT_NEAR(heard.back().data(), 2, 1e-12);
}

TEST_F(EnvironmentalSensorTest, IsSilentOutsideOfTheTable) {
  RunningWorld running(world("", "humidity", "0 0 -1.5 0 0 0") + environment(table()));
  std::vector<Double> heard;
  running.listen(kTopic, heard);
  running.step(10);
  EXPECT_TRUE(heard.empty());
  ASSERT_TRUE(running.model("m").setPose({Vector3(1, 1, 1), Quaternion::Identity()}));
  running.step(1);
  EXPECT_EQ(heard.size(), 1U) << "its corners belong to it";
}

/// As Gazebo's own test of transformations tells it: the sensor drives along x and looks along y.
TEST_F(EnvironmentalSensorTest, TransformsVectors) {
  const auto measured = [&](const std::string& transform) {
    RunningWorld running(world("<output_format>vector3</output_format><topic>/flow</topic>"
                               "<environment_variable_x>u</environment_variable_x>" +
                                   transform,
                               "flow", "0 0 0 0 0 1.5707963267948966") +
                         environment("time,u,x,y,z\n0,-3,-1,-1,-1\n0,-3,1,1,1\n0,-3,-1,-1,1\n0,-3,-1,1,-1\n"
                                     "0,-3,1,-1,-1\n0,-3,1,1,-1\n0,-3,1,-1,1\n0,-3,-1,1,1\n",
                                     "<time>time</time><ignore_time>true</ignore_time>"));
    running.model("m").setVelocity({1, 0, 0}, Vector3::Zero());
    std::vector<ignition::msgs::Vector3d> heard;
    running.listen("/flow", heard);
    running.step(1);
    EXPECT_EQ(heard.size(), 1U);
    return Vector3(heard.at(0).x(), heard.at(0).y(), heard.at(0).z());
  };
  const auto type = [](const std::string& name) { return "<transform_type>" + name + "</transform_type>"; };
  EXPECT_TRUE(measured("").isApprox(Vector3(-3, 0, 0), 1e-9));
  EXPECT_TRUE(measured(type("GLOBAL")).isApprox(Vector3(-3, 0, 0), 1e-9));
  EXPECT_TRUE(measured(type("LOCAL")).isApprox(Vector3(0, 3, 0), 1e-9));
  EXPECT_TRUE(measured(type("ADD_VELOCITY_GLOBAL")).isApprox(Vector3(-4, 0, 0), 1e-9));
  EXPECT_TRUE(measured(type("ADD_VELOCITY_LOCAL")).isApprox(Vector3(0, 4, 0), 1e-9));
}

/// As Gazebo's own test of the table tells it.
TEST_F(EnvironmentalSensorTest, KnowsPlacesOnTheEarth) {
  const std::string place =
      "<spherical_coordinates><surface_model>EARTH_WGS84</surface_model><latitude_deg>36.80079505</latitude_deg>"
      "<longitude_deg>-121.789472517</longitude_deg><elevation>0</elevation><heading_deg>0</heading_deg>"
      "</spherical_coordinates>";
  // the grid's layers hold the earth's curvature, 0.4 mm over 74 m
  std::string csv = "t,humidity,latitude,longitude,altitude\n";
  for (const char* const altitude : {"0.7", "0.9"}) {
    for (const char* const point : {"91,36.80029505,-121.788972517", "88,36.80129505,-121.788972517",
                                    "89,36.80029505,-121.789972517", "92,36.80129505,-121.789972517"}) {
      csv += std::string("0,") + point + "," + altitude + "\n";
    }
  }
  const std::string space =
      "<ignore_time>true</ignore_time><space reference='spherical' units='degrees'><x>latitude</x><y>longitude</y>"
      "<z>altitude</z></space>";
  RunningWorld running(place + world("", "humidity", "0 0 0.8 0 0 0") + environment(csv, space));
  std::vector<Double> heard;
  running.listen(kTopic, heard);
  running.step(1);
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_NEAR(heard[0].data(), 90, 1e-6);
  // to the south-east corner: 0.0005 degrees of latitude are 55.5 m here, of longitude 44.6 m
  ASSERT_TRUE(running.model("m").setPose({Vector3(44.6, -55.48, 0.8), Quaternion::Identity()}));
  running.step(1);
  ASSERT_EQ(heard.size(), 2U);
  EXPECT_NEAR(heard[1].data(), 91, 0.01);
}

TEST_F(EnvironmentalSensorTest, SaysOnceWhyItMeasuresNothing) {
  const auto said = [&](const std::string& content) {
    RunningWorld running(content);
    std::vector<Double> heard;
    running.listen(kTopic, heard);
    testing::internal::CaptureStderr();
    running.step(3);
    const std::string text = testing::internal::GetCapturedStderr();
    const std::string marker = "sensor 'm::l::s' measures nothing: ";
    const std::size_t at = text.find(marker);
    EXPECT_EQ(text.find(marker, at + 1), std::string::npos) << "once";
    return at == std::string::npos ? text : text.substr(at + marker.size(), text.find('\n', at) - at - marker.size());
  };
  EXPECT_EQ(said(world("")), "the world has no environment, which EnvironmentPreload reads");
  EXPECT_EQ(said(world("", "heat") + environment(table())), "the environment has no 'heat', but humidity, u, v, w");
  EXPECT_EQ(said(world("") + environment(table(), "<time>time</time><space reference='ecef'/>")),
            "the world needs <spherical_coordinates>");
}

TEST_F(EnvironmentalSensorTest, WarnsOfUnknownWords) {
  EXPECT_EQ(RunningWorld::complaintsAbout(world("<output_format>matrix</output_format>")),
            std::vector<std::string>{"<output_format> 'matrix' is unknown: scalar is used, as in Gazebo"});
  EXPECT_EQ(RunningWorld::complaintsAbout(
                world("<output_format>vector3</output_format><transform_type>SIDEWAYS</transform_type>")),
            std::vector<std::string>{"<transform_type> 'SIDEWAYS' is unknown: GLOBAL is used, as in Gazebo"});
}

}  // namespace
}  // namespace pongsim::environmental_sensor_test
