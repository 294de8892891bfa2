#include <gtest/gtest.h>
#include <ignition/msgs/double.pb.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "support/running_world.hh"
#include "support/temp_folder.hh"

namespace pongsim::environment_preload_test {
namespace {

using test::RunningWorld;

constexpr const char* kTable =
    "t,humidity,x,y,z\n"
    "0,10,-1,-1,-1\n0,10,-1,-1,1\n0,10,-1,1,-1\n0,10,-1,1,1\n"
    "0,20,1,-1,-1\n0,20,1,-1,1\n0,20,1,1,-1\n0,20,1,1,1\n";

class EnvironmentPreloadTest : public testing::Test {
 protected:
  std::string file(const std::string& content, const std::string& name = "data.csv") const {
    const std::filesystem::path path = folder_.path() / name;
    std::ofstream(path) << content;
    return path.string();
  }

  static std::string plugin(const std::string& parameters) {
    return "<plugin filename='gz-sim-environment-preload-system' name='gz::sim::systems::EnvironmentPreload'>" +
           parameters + "</plugin>";
  }
  static std::string plugin(const std::string& data, const std::string& dimensions) {
    return plugin("<data>" + data + "</data><dimensions>" + dimensions + "</dimensions>");
  }

  /// What is said of a table.
  std::vector<std::string> saidOf(const std::string& csv, const std::string& dimensions = "") const {
    return RunningWorld::complaintsAbout(plugin(file(csv), dimensions));
  }
  std::string left(const std::string& why) const {
    return "environment-preload is left out: '" + (folder_.path() / "data.csv").string() + "' can't be read: " + why;
  }

  test::TempFolder folder_;
};

TEST_F(EnvironmentPreloadTest, ReadsATableForSensors) {
  const std::string sensor =
      "<plugin filename='gz-sim-environmental-sensor-system' name='gz::sim::systems::EnvironmentalSystem'/>"
      "<gravity>0 0 0</gravity><model name='m'><link name='l'><inertial><mass>1</mass></inertial>"
      "<sensor name='s' type='custom' gz:type='environmental_sensor/humidity'><topic>/humidity</topic></sensor>"
      "</link></model>";
  RunningWorld world(sensor + plugin(file(kTable), "<ignore_time>true</ignore_time>"));
  std::vector<ignition::msgs::Double> heard;
  world.listen("/humidity", heard);
  world.step(1);
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_EQ(heard[0].data(), 15);
}

TEST_F(EnvironmentPreloadTest, WarnsOfATableForOneTimeOnly) {
  EXPECT_EQ(saidOf(kTable), std::vector<std::string>{"'" + (folder_.path() / "data.csv").string() +
                                                     "' has values for the time 0 s only"});
  EXPECT_TRUE(saidOf(kTable, "<ignore_time>1</ignore_time>").empty());
}

TEST_F(EnvironmentPreloadTest, WarnsOfGapsInTheGrid) {
  EXPECT_EQ(saidOf("t,h,x,y,z\n0,1,0,0,0\n0,1,1,1,0\n", "<ignore_time>1</ignore_time>"),
            std::vector<std::string>{"'" + (folder_.path() / "data.csv").string() +
                                     "' lacks 2 points of its grid: they count as zero, as in Gazebo"});
}

TEST_F(EnvironmentPreloadTest, SaysWhatIsWrongWithATable) {
  using Said = std::vector<std::string>;
  EXPECT_EQ(saidOf(""), Said{left("its first line has no names of columns")});
  EXPECT_EQ(saidOf("t,x,y,z,h\n"), Said{left("it has no values")});
  EXPECT_EQ(saidOf(kTable, "<time>timestamp</time>"),
            Said{left("it has no column 'timestamp', but t, humidity, x, y, z")});
  EXPECT_EQ(saidOf(kTable, "<space><x>y</x></space>"), Said{left("the column 'y' can't be used twice")});
  EXPECT_EQ(saidOf("t,x,y,z,h\n0,0,0,0,1\n0,0,0,0\n"), Said{left("line 3 has 4 cells, where the first line has 5")});
  for (const char* number : {"nan", "inf", "", "one", "1e999", "1;2"}) {
    EXPECT_EQ(saidOf(std::string("t,x,y,z,h\n\n0,0,0,0,") + number + "\n"),
              Said{left(std::string("line 3 has '") + number + "' in the column 'h', which is not a finite number")});
  }
}

TEST_F(EnvironmentPreloadTest, SaysWhatIsWrongWithItsParameters) {
  using Said = std::vector<std::string>;
  const std::string out = "environment-preload is left out: ";
  EXPECT_EQ(RunningWorld::complaintsAbout(plugin("")), Said{out + "no <data> is given"});
  EXPECT_EQ(saidOf(kTable, "<space reference='local'/>"), Said{out + "<space> has the unknown reference 'local'"});
  EXPECT_EQ(saidOf(kTable, "<space units='grad'/>"), Said{out + "<space> has the unknown units 'grad'"});
  const std::string one = plugin(file(kTable), "<ignore_time>true</ignore_time>");
  EXPECT_EQ(RunningWorld::complaintsAbout(one + one), Said{out + "the world has an environment already"});
}

TEST_F(EnvironmentPreloadTest, ReadsRegularFilesOnly) {
  using Said = std::vector<std::string>;
  const std::string none = (folder_.path() / "none.csv").string();
  EXPECT_EQ(RunningWorld::complaintsAbout(plugin(none, "")),
            Said{"environment-preload is left out: '" + none + "' is not found"});
  const std::string pipe = (folder_.path() / "pipe.csv").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(RunningWorld::complaintsAbout(plugin(pipe, "")),
            Said{"environment-preload is left out: '" + pipe + "' is a named pipe, not a file"});
  const std::string big = file("t,x,y,z\n", "big.csv");
  std::filesystem::resize_file(big, 300 << 20);
  EXPECT_EQ(RunningWorld::complaintsAbout(plugin(big, "")),
            Said{"environment-preload is left out: '" + big + "' is larger than 256 MiB, which is the limit"});
}

}  // namespace
}  // namespace pongsim::environment_preload_test
