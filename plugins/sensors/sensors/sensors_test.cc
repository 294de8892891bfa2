#include <gtest/gtest.h>
#include <ignition/msgs/laserscan.pb.h>
#include <ignition/msgs/pointcloud_packed.pb.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::sensors_test {
namespace {

using ignition::msgs::LaserScan;
using ignition::msgs::PointCloudPacked;
using test::RunningWorld;

constexpr const char* kSystem =
    "<plugin filename='ignition-gazebo-sensors-system' name='ignition::gazebo::systems::Sensors'/>";
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// @return A lidar 1 m high that looks along x, its `<sensor>` with that type and content.
std::string lidar(const std::string& content, const std::string& type = "gpu_lidar") {
  return kSystem +
         ("<model name='m'><static>true</static><pose>0 0 1 0 0 0</pose><link name='l'><sensor name='s' type='" + type +
          "'>") +
         content + "</sensor></link></model>";
}

/// @param scan, range Further elements of either.
std::string beams(const std::string& horizontal, const std::string& vertical = "", const std::string& more = "") {
  return "<topic>scan</topic><lidar><scan><horizontal>" + horizontal + "</horizontal><vertical>" + vertical +
         "</vertical></scan><range><min>0.5</min><max>10</max></range>" + more + "</lidar>";
}

std::string box(const std::string& name, const std::string& pose, const std::string& more = "") {
  return "<model name='" + name + "'><static>true</static><pose>" + pose + "</pose><link name='l'><visual name='v'>" +
         more + "<geometry><box><size>2 40 40</size></box></geometry></visual></link></model>";
}

std::vector<LaserScan> scansOf(const std::string& content, std::uint64_t steps = 1) {
  RunningWorld world(content);
  std::vector<LaserScan> scans;
  world.listen("/scan", scans);
  world.step(steps);
  return scans;
}

TEST(Sensors, MeasureAlongEachBeamFromTheLowestRowOn) {
  const std::vector<LaserScan> scans =
      scansOf(lidar(beams("<samples>3</samples><min_angle>-0.6</min_angle><max_angle>0.6</max_angle>",
                          "<samples>2</samples><min_angle>-0.2</min_angle><max_angle>0.4</max_angle>")) +
              box("wall", "5 0 1 0 0 0"));
  ASSERT_EQ(scans.size(), 1U);
  const LaserScan& scan = scans[0];
  ASSERT_EQ(scan.ranges_size(), 6);
  ASSERT_EQ(scan.intensities_size(), 6);
  const double rows[] = {-0.2, 0.4}, columns[] = {-0.6, 0, 0.6};
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(scan.ranges(i), 4 / std::cos(rows[i / 3]) / std::cos(columns[i % 3]), 1e-9) << i;
  }
}

TEST(Sensors, InAWorldThatHadNoneWorkAfterTheFirstIsInserted) {
  RunningWorld world(kSystem + box("wall", "5 0 1 0 0 0"));
  std::vector<LaserScan> scans;
  world.listen("/scan", scans);
  world.step(2);
  const std::string sensor = beams("<samples>3</samples><min_angle>-0.6</min_angle><max_angle>0.6</max_angle>");
  const std::string model =
      "<sdf version='1.9'><model name='m'><static>true</static><pose>0 0 1 0 0 0</pose><link "
      "name='l'><sensor name='s' type='gpu_lidar'>" +
      sensor + "</sensor></link></model></sdf>";
  Diagnostics diagnostics;
  for (int time = 0; time < 2; ++time) {
    ASSERT_TRUE(world.simulation().insertText(model, "lidar.sdf", {}, diagnostics));
    world.step(2);
    ASSERT_FALSE(scans.empty());
    EXPECT_NEAR(scans.back().ranges(1), 4, 1e-9);
    scans.clear();
    ASSERT_TRUE(world.simulation().remove(world.model("m")));
    world.step(2);
    EXPECT_TRUE(scans.empty());
  }
  EXPECT_TRUE(diagnostics.all().empty());
}

TEST(Sensors, TellWhatTheirBeamsAre) {
  const std::vector<LaserScan> scans =
      scansOf(lidar(beams("<samples>5</samples><resolution>2</resolution><min_angle>-0.9</min_angle>"
                          "<max_angle>0.9</max_angle>",
                          "<samples>1</samples><resolution>0.01</resolution>") +
                    "<ignition_frame_id>f</ignition_frame_id>"),
              2);
  ASSERT_EQ(scans.size(), 2U);
  const LaserScan& scan = scans[1];
  EXPECT_EQ(scan.frame(), "f");
  EXPECT_EQ(scan.count(), 10U);
  EXPECT_EQ(scan.ranges_size(), 10);
  EXPECT_DOUBLE_EQ(scan.angle_min(), -0.9);
  EXPECT_DOUBLE_EQ(scan.angle_max(), 0.9);
  EXPECT_DOUBLE_EQ(scan.angle_step(), 0.2);
  EXPECT_EQ(scan.vertical_count(), 1U);
  EXPECT_EQ(scan.vertical_angle_step(), 0);
  EXPECT_DOUBLE_EQ(scan.range_min(), 0.5);
  EXPECT_DOUBLE_EQ(scan.range_max(), 10);
  EXPECT_DOUBLE_EQ(scan.world_pose().position().z(), 1);
  ASSERT_EQ(scan.header().data_size(), 2);
  EXPECT_EQ(scan.header().data(0).value(0), "f");
  EXPECT_EQ(scan.header().data(1).value(0), "1");
  EXPECT_EQ(scan.header().stamp().nsec(), 2'000'000);
}

TEST(Sensors, AreInfiniteWhereNothingIsOrItIsTooNear) {
  const auto range = [](const std::string& boxes) {
    return scansOf(lidar(beams("<samples>1</samples>")) + boxes).at(0).ranges(0);
  };
  EXPECT_EQ(range(""), kInfinity);
  EXPECT_EQ(range(box("b", "12 0 1 0 0 0")), kInfinity);
  EXPECT_EQ(range(box("b", "1.4 0 1 0 0 0")), -kInfinity);
  EXPECT_NEAR(range(box("b", "1.6 0 1 0 0 0")), 0.6, 1e-9);
  // who stands in a box looks out of it
  EXPECT_NEAR(range(box("b", "0 0 1 0 0 0") + box("c", "4 0 1 0 0 0")), 3, 1e-9);
}

TEST(Sensors, SeeWhatTheirMaskLetsThroughAndHowMuchItReflects) {
  const std::vector<LaserScan> scans =
      scansOf(lidar(beams("<samples>1</samples>", "", "<visibility_mask>2</visibility_mask>")) +
              box("b", "3 0 1 0 0 0", "<visibility_flags>1</visibility_flags>") +
              box("c", "6 0 1 0 0 0", "<visibility_flags>2</visibility_flags><laser_retro>30</laser_retro>"));
  EXPECT_NEAR(scans.at(0).ranges(0), 5, 1e-9);
  EXPECT_EQ(scans.at(0).intensities(0), 30);
}

TEST(Sensors, AreLidarsByAnyOfTheirNames) {
  for (const char* type : {"gpu_lidar", "lidar", "gpu_ray", "ray"}) {
    EXPECT_EQ(scansOf(lidar(beams("<samples>2</samples>"), type)).size(), 1U) << type;
  }
}

TEST(Sensors, SpeakOnTheirOwnTopicAtTheirRate) {
  RunningWorld world(lidar("<update_rate>100</update_rate>"));
  std::vector<LaserScan> scans;
  world.listen("/world/w/model/m/link/l/sensor/s/scan", scans);
  world.step(100);
  EXPECT_EQ(scans.size(), 11U);
  EXPECT_EQ(scans.back().frame(), "m::l::s");
  EXPECT_EQ(scans.back().ranges_size(), 640);
}

TEST(Sensors, AddTheNoiseThatTheFileAsksForWithinTheirRange) {
  const std::string noise = "<noise><type>gaussian</type><mean>0.1</mean><stddev>0.2</stddev></noise>";
  const auto scans = [&](const std::string& boxes) {
    return scansOf(lidar(beams("<samples>3</samples>", "", noise)) + boxes, 1000);
  };
  double sum = 0, squares = 0;
  for (const LaserScan& scan : scans(box("b", "5 0 1 0 0 0"))) {
    for (const double range : scan.ranges()) {
      sum += range - 4;
      squares += std::pow(range - 4.1, 2);
    }
  }
  EXPECT_NEAR(sum / 3000, 0.1, 0.02);
  EXPECT_NEAR(std::sqrt(squares / 3000), 0.2, 0.02);
  for (const LaserScan& scan : scans(box("b", "10.95 0 1 0 0 0"))) EXPECT_LE(scan.ranges(0), 10);
  for (const LaserScan& scan : scans("")) EXPECT_EQ(scan.ranges(0), kInfinity);
}

/// @return The value that lies there in a cloud's data.
template <class Value>
Value valueAt(const PointCloudPacked& cloud, std::size_t offset) {
  Value value;
  std::memcpy(&value, cloud.data().data() + offset, sizeof(value));
  return value;
}

TEST(Sensors, TellTheSameAsPoints) {
  RunningWorld world(lidar(beams("<samples>2</samples><min_angle>0.3</min_angle><max_angle>0.6</max_angle>",
                                 "<samples>2</samples><min_angle>-0.1</min_angle><max_angle>0.2</max_angle>")) +
                     box("wall", "5 0 1 0 0 0", "<laser_retro>7</laser_retro>"));
  std::vector<PointCloudPacked> clouds;
  world.listen("/scan/points", clouds);
  world.step(1);
  ASSERT_EQ(clouds.size(), 1U);
  const PointCloudPacked& cloud = clouds[0];
  std::string fields;
  for (const PointCloudPacked::Field& field : cloud.field()) {
    fields += field.name() + ' ' + std::to_string(field.offset()) + ' ' +
              PointCloudPacked::Field::DataType_Name(field.datatype()) + ", ";
  }
  EXPECT_EQ(fields, "x 0 FLOAT32, y 4 FLOAT32, z 8 FLOAT32, intensity 16 FLOAT32, ring 24 UINT16, ");
  EXPECT_EQ(cloud.width(), 2U);
  EXPECT_EQ(cloud.height(), 2U);
  EXPECT_EQ(cloud.point_step(), 32U);
  EXPECT_EQ(cloud.row_step(), 64U);
  EXPECT_TRUE(cloud.is_dense());
  EXPECT_EQ(cloud.header().data(0).value(0), "m::l::s");
  ASSERT_EQ(cloud.data().size(), 128U);
  // the last point, of the upper row
  EXPECT_NEAR(valueAt<float>(cloud, 96), 4, 1e-6);
  EXPECT_NEAR(valueAt<float>(cloud, 100), 4 * std::tan(0.6), 1e-6);
  EXPECT_NEAR(valueAt<float>(cloud, 104), 4 * std::tan(0.2) / std::cos(0.6), 1e-6);
  EXPECT_EQ(valueAt<float>(cloud, 112), 7);
  EXPECT_EQ(valueAt<std::uint16_t>(cloud, 120), 1);
}

TEST(Sensors, SayThatACloudHasHoles) {
  RunningWorld world(lidar(beams("<samples>1</samples>")));
  std::vector<PointCloudPacked> clouds;
  world.listen("/scan/points", clouds);
  world.step(1);
  ASSERT_EQ(clouds.size(), 1U);
  EXPECT_FALSE(clouds[0].is_dense());
  EXPECT_EQ(valueAt<float>(clouds[0], 0), std::numeric_limits<float>::infinity());
}

TEST(Sensors, SeeModelsThatComeAndGo) {
  RunningWorld world(lidar(beams("<samples>1</samples>")) + box("far", "8 0 1 0 0 0"));
  std::vector<LaserScan> scans;
  world.listen("/scan", scans);
  world.step(1);
  EXPECT_NEAR(scans.back().ranges(0), 7, 1e-9);
  Diagnostics diagnostics;
  const auto near = world.simulation().insertText("<sdf version='1.9'>" + box("near", "4 0 1 0 0 0") + "</sdf>",
                                                  "near.sdf", {}, diagnostics);
  ASSERT_TRUE(near);
  world.step(1);
  EXPECT_NEAR(scans.back().ranges(0), 3, 1e-9);
  world.model("near").setPose({{5, 0, 1}, Quaternion::Identity()});
  world.step(1);
  EXPECT_NEAR(scans.back().ranges(0), 4, 1e-9);
  EXPECT_TRUE(world.simulation().remove(*near));
  world.step(1);
  EXPECT_NEAR(scans.back().ranges(0), 7, 1e-9);
}

TEST(Sensors, WarnOfLidarsThatCantBeHadAndOfMeshesThatCantBeRead) {
  const std::string huge = "<samples>5000</samples><resolution>2</resolution>";
  EXPECT_EQ(RunningWorld::complaintsAbout(lidar(beams(huge, "<samples>1000</samples>"))),
            std::vector<std::string>{"lidar 'm::l::s' has more than 1000000 beams: it is left out"});
  EXPECT_EQ(RunningWorld::complaintsAbout(lidar(beams("<samples>4000000000</samples>"))).size(), 1U);
  const std::vector<std::string> complaints = RunningWorld::complaintsAbout(
      lidar(beams("<samples>1</samples>")) +
      "<model name='n'><static>true</static><link name='l'><visual name='v'><geometry><mesh><uri>" +
      (test::projectFolder() / "README.md").string() + "</uri></mesh></geometry></visual></link></model>");
  ASSERT_EQ(complaints.size(), 1U);
  EXPECT_NE(complaints[0].find("visual 'v' of link 'l' will not be seen by sensors"), std::string::npos);
}

/// The tutorial's wall stands across x, its front at this place [m].
constexpr double kWall = 4.75;

TEST(Sensors, OfFortressTutorialSeeItsWallAndItsGround) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  RunningWorld world(*worlds / "tutorials/sensor_tutorial.sdf");
  std::vector<LaserScan> scans;
  world.listen("/lidar", scans);
  world.step(1000);
  ASSERT_EQ(scans.size(), 11U);
  int walls = 0;
  for (const LaserScan& scan : scans) {
    ASSERT_EQ(scan.ranges_size(), 640);
    const auto& place = scan.world_pose().position();
    const auto& turned = scan.world_pose().orientation();
    const Pose X_WorldLidar{{place.x(), place.y(), place.z()}, {turned.w(), turned.x(), turned.y(), turned.z()}};
    for (int i = 0; i < 640; ++i) {
      if (!std::isfinite(scan.ranges(i))) continue;
      const double angle = scan.angle_min() + i * scan.angle_step();
      const Vector3 point = X_WorldLidar * (scan.ranges(i) * Vector3(std::cos(angle), std::sin(angle), 0));
      EXPECT_TRUE(std::abs(point.x() - kWall) < 1e-6 || std::abs(point.z()) < 1e-6) << point.transpose();
      if (std::abs(point.x() - kWall) < 1e-6) ++walls;
    }
  }
  EXPECT_GT(walls, 2000);
}

}  // namespace
}  // namespace pongsim::sensors_test
