#include "golden/recording.hh"

#include <gtest/gtest.h>

#include <fstream>

#include "support/temp_folder.hh"

namespace pongsim::test {
namespace {

TEST(Recording, ReadsWhatIsThereOfEachLine) {
  const TempFolder folder;
  const auto file = folder.path() / "recording.csv";
  std::ofstream(file) << "t,what,name,v0,v1,v2,v3,v4,v5,v6\n"
                         "0.001,joint,robot::hinge,0.5,,,,,,\n"
                         "0.100,model,robot,1,2,3,1,0,0,0\n";
  const std::vector<RecordedRow> rows = readRecording(file);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].time, std::chrono::milliseconds(1));
  EXPECT_EQ(rows[0].what, "joint");
  EXPECT_EQ(rows[0].values, std::vector<double>{0.5});
  EXPECT_EQ(rows[1].name, "robot");
  EXPECT_EQ(rows[1].values, (std::vector<double>{1, 2, 3, 1, 0, 0, 0}));
}

// The models fall the same way in both, because only gravity acts on them.
TEST(Replay, ComparesModelsAndLinksWithTheRecording) {
  if (!Replay::isHere()) GTEST_SKIP() << "Fortress's worlds or recordings are not here";
  Replay replay("test/battery.sdf");
  replay.run();
  EXPECT_TRUE(replay.missing().empty());
  EXPECT_LT(replay.of("model linear_battery_demo_model").largest, 1e-3);
  EXPECT_LT(replay.of("link linear_battery_demo_model::body").largestAngle, 1e-3);
}

}  // namespace
}  // namespace pongsim::test
