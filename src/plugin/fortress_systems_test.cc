#include "plugin/fortress_systems.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace pongsim::plugin {
namespace {

TEST(FortressSystems, ListsEachLibraryOfFortressOnce) {
  const auto names = fortressSystems();
  EXPECT_EQ(names.size(), 61U);
  EXPECT_TRUE(std::ranges::is_sorted(names));
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

TEST(FortressSystems, AreMissingWhereNoLibraryNoPackageAndNotPongsimItselfDoesTheirWork) {
  const auto missing = missingSystems(std::vector<std::string>{"imu", "my-system"});
  // what follows Fortress's is of later releases; one of them is in a package, and one part of pongsim
  EXPECT_EQ(missing.size(), fortressSystems().size() - 10 + laterSystems().size() - 2);
  for (const char* name : {"camera-video-recorder", "entity-semantics", "imu", "label", "log", "log-video-recorder",
                           "physics", "shader-param", "thermal", "thermal-sensor", "user-commands", "websocket-server"})
    EXPECT_EQ(std::ranges::count(missing, name), 0) << name;
  for (const char* name : {"buoyancy", "air-speed"}) EXPECT_EQ(std::ranges::count(missing, name), 1) << name;
}

TEST(FortressSystems, AreBesideThoseOfLaterReleases) {
  for (const LaterSystem& system : laterSystems()) {
    EXPECT_EQ(std::ranges::count(fortressSystems(), system.name), 0) << system.name;
    EXPECT_EQ(std::ranges::count(laterSystems(), system.name, &LaterSystem::name), 1) << system.name;
  }
  for (const char* name : {"imu", "dvl"}) EXPECT_TRUE(isOfGazebo(name)) << name;
  EXPECT_FALSE(isOfGazebo("my-system"));
}

}  // namespace
}  // namespace pongsim::plugin
