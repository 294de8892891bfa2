#include <limits>

#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

Loaded loadLidar(const std::string& content, const std::string& element = "lidar") {
  return loadLink("<sensor name='s' type='gpu_lidar'>\n<" + element + ">" + content + "</" + element + "></sensor>");
}

const LidarSettings& lidarOf(const Loaded& loaded) {
  return std::get<LidarSettings>(loaded.model().links.at(0).sensors.at(0).settings);
}

TEST(Lidar, HasTheDefaultsOfTheFormat) {
  const LidarSettings lidar = lidarOf(loadLidar(""));
  EXPECT_EQ(lidar, LidarSettings());
  EXPECT_EQ(lidar.horizontal.samples, 640U);
  EXPECT_EQ(lidar.vertical.samples, 1U);
}

TEST(Lidar, ReadsAllUnderBothNames) {
  for (const char* element : {"lidar", "ray"}) {
    const LidarSettings lidar = lidarOf(loadLidar(
        "<scan><horizontal><samples>100</samples><resolution>0.5</resolution><min_angle>-1</min_angle>"
        "<max_angle>1</max_angle></horizontal><vertical><samples>16</samples><min_angle>-0.1</min_angle></vertical>"
        "</scan><range><min>0.1</min><max>inf</max><resolution>0.01</resolution></range>"
        "<noise><type>gaussian</type><mean>0.2</mean><stddev>0.3</stddev></noise><visibility_mask>6</visibility_mask>",
        element));
    EXPECT_EQ(lidar.horizontal, (LidarSettings::Scan{100, 0.5, -1, 1}));
    EXPECT_EQ(lidar.vertical, (LidarSettings::Scan{16, 1, -0.1, 0}));
    EXPECT_EQ(lidar.minRange, 0.1);
    EXPECT_EQ(lidar.maxRange, std::numeric_limits<double>::infinity());
    EXPECT_EQ(lidar.rangeResolution, 0.01);
    EXPECT_EQ(lidar.noise.type, NoiseSettings::Type::kGaussian);
    EXPECT_EQ(lidar.noise.mean, 0.2);
    EXPECT_EQ(lidar.noise.standardDeviation, 0.3);
    EXPECT_EQ(lidar.visibilityMask, 6U);
  }
}

TEST(Lidar, SaysWhatIsWrong) {
  const auto message = [](const std::string& content) { return loadLidar(content).messages.at(0); };
  EXPECT_EQ(message("<scan><horizontal><samples>0</samples></horizontal></scan>"),
            "t.sdf:5:26: error: <samples> is '0', which is not an integer from 1 to 4294967295");
  EXPECT_EQ(message("<scan><horizontal><min_angle>1</min_angle></horizontal></scan>"),
            "t.sdf:5:14: error: the horizontal scan of sensor 's' has a <min_angle> above its <max_angle>");
  EXPECT_EQ(message("<range><min>2</min><max>1</max></range>"),
            "t.sdf:5:8: error: sensor 's' sees nothing: <min> of its range is above <max>");
  EXPECT_EQ(message("<range><max>nan</max></range>"), "t.sdf:5:15: error: <max> is 'nan', which is not a number");
}

}  // namespace
}  // namespace pongsim::sdf::test
