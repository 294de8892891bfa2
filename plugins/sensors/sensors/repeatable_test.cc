// Readings are bit-for-bit reproducible, with any subscribers and any number of physics threads.

#include <gtest/gtest.h>
#include <ignition/msgs/laserscan.pb.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "pongsim/simulation.hh"
#include "support/running_world.hh"

namespace pongsim::repeatable_test {
namespace {

/// Towers that fall apart from each other, each a group of bodies of its own; before them a lidar and a camera with
/// noise, and beside these others.
std::string fallingTowers() {
  const std::string noise = "<noise><type>gaussian</type><mean>0</mean><stddev>0.03</stddev></noise>";
  const auto sensor = [](const std::string& name, const std::string& type, const std::string& content) {
    return "<sensor name='" + name + "' type='" + type + "'><topic>" + name +
           "/it</topic><update_rate>20</update_rate>" + content + "</sensor>";
  };
  const auto lidar = [&](const std::string& name) {
    return sensor(name, "gpu_lidar",
                  "<lidar><scan><horizontal><samples>90</samples><min_angle>-0.8</min_angle><max_angle>0.8</max_angle>"
                  "</horizontal></scan><range><min>0.1</min><max>30</max></range>" +
                      noise + "</lidar>");
  };
  const auto camera = [&](const std::string& name) {
    return sensor(name, "camera", "<camera><image><width>64</width><height>48</height></image>" + noise + "</camera>");
  };
  std::string content =
      "<plugin filename='ignition-gazebo-sensors-system' name='ignition::gazebo::systems::Sensors'/>"
      "<light name='sun' type='directional'><cast_shadows>true</cast_shadows></light>"
      "<model name='ground'><static>true</static><link name='l'><collision name='c'><geometry><plane/></geometry>"
      "</collision></link></model><model name='m'><static>true</static><pose>-6 0 0.6 0 0 0</pose><link name='l'>" +
      lidar("lidar") + camera("camera") + lidar("other_lidar") + camera("other_camera") + "</link></model>";
  for (int i = 0; i < 24; ++i) {
    const std::string size = "<geometry><box><size>0.5 0.5 0.5</size></box></geometry>";
    content += "<model name='b" + std::to_string(i) + "'><pose>" + std::to_string(0.06 * i) + ' ' +
               std::to_string(i % 4 * 3 - 4.5) + ' ' + std::to_string(0.3 + i / 4 * 0.55) +
               " 0.1 0.2 0.3</pose><link name='l'><collision name='c'>" + size + "</collision><visual name='v'>" +
               size + "</visual></link></model>";
  }
  return content;
}

/// Who listens beside the test to the lidar and the camera.
enum class Others { kNone, kMany };

struct Readings {
  /// The bytes of each message, from the step on from which somebody listened.
  std::vector<std::string> scans;
  std::vector<std::string> images;
  std::uint64_t stateHash = 0;
  /// Without libosmesa6 there are no images.
  bool canDraw = false;
};

constexpr std::uint64_t kSteps = 600;

Readings readingsOf(int threads, Others others, std::uint64_t heardFrom = 0) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(test::RunningWorld::textOf(fallingTowers()), "towers.sdf",
                                               {.seed = 7, .threads = threads}, diagnostics);
  if (simulation == nullptr) throw std::runtime_error("the world is broken");
  Node node = simulation->transport().node();
  std::vector<Subscription> subscriptions;
  const auto listen = [&](const char* topic, const char* type, std::vector<std::string>* into) {
    subscriptions.push_back(node.subscribe(topic, type, [into](const Message& message) {
      if (into != nullptr) into->push_back(message.SerializeAsString());
    }));
  };
  if (others == Others::kMany) {
    listen("/other_lidar/it", "ignition.msgs.LaserScan", nullptr);
    listen("/other_camera/it", "ignition.msgs.Image", nullptr);
    listen("/lidar/it/points", "ignition.msgs.PointCloudPacked", nullptr);
    listen("/camera/camera_info", "ignition.msgs.CameraInfo", nullptr);
  }
  Readings readings;
  readings.canDraw = diagnostics.all().empty();
  simulation->step(heardFrom);
  if (heardFrom < kSteps) {
    listen("/lidar/it", "ignition.msgs.LaserScan", &readings.scans);
    listen("/camera/it", "ignition.msgs.Image", &readings.images);
  }
  simulation->step(kSteps - heardFrom);
  simulation->transport().dispatch();
  readings.stateHash = simulation->stateHash();
  return readings;
}

TEST(Readings, AreTheSameBitsWhateverListensAndHoweverManyThreadsThereAre) {
  const Readings expected = readingsOf(1, Others::kNone);
  ASSERT_EQ(expected.scans.size(), 13U);
  EXPECT_EQ(expected.images.size(), expected.canDraw ? 13U : 0U);
  EXPECT_NE(expected.scans.front(), expected.scans.back());
  for (const int threads : {1, 2}) {
    for (const Others others : {Others::kNone, Others::kMany}) {
      const Readings found = readingsOf(threads, others);
      const std::string who = std::to_string(threads) + (others == Others::kMany ? " threads, others" : " threads");
      EXPECT_EQ(found.stateHash, expected.stateHash) << who;
      EXPECT_TRUE(found.scans == expected.scans) << who;
      EXPECT_TRUE(found.images == expected.images) << who;
    }
  }
}

TEST(Readings, OfWhoComesLaterAreThoseThatTheOthersHear) {
  const Readings whole = readingsOf(1, Others::kNone), late = readingsOf(2, Others::kMany, kSteps / 2),
                 unheard = readingsOf(2, Others::kNone, kSteps);
  EXPECT_EQ(late.stateHash, whole.stateHash);
  EXPECT_EQ(unheard.stateHash, whole.stateHash);
  const auto isEndOf = [](const std::vector<std::string>& end, const std::vector<std::string>& all) {
    return end.size() <= all.size() && std::equal(end.rbegin(), end.rend(), all.rbegin());
  };
  EXPECT_EQ(late.scans.size(), 6U);
  EXPECT_TRUE(isEndOf(late.scans, whole.scans));
  EXPECT_TRUE(isEndOf(late.images, whole.images));
}

}  // namespace
}  // namespace pongsim::repeatable_test
