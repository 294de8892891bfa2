#include "load_support.hh"

namespace pongsim::sdf::test {
namespace {

TEST(Unsimulated, SensorsAreNamedOnceAType) {
  EXPECT_EQ(loadLink("<sensor name='a' type='imu'/>\n<sensor name='b' type='imu'/>\n<sensor name='c' type='lidar'/>")
                .messages,
            (Messages{"t.sdf:4:1: warning: sensor type 'imu' is not simulated yet",
                      "t.sdf:6:1: warning: sensor type 'lidar' is not simulated yet"}));
}

TEST(Unsimulated, KindsAreNamedOnce) {
  EXPECT_EQ(loadWorld("<actor name='a'/><actor name='b'/>").messages,
            Messages{"t.sdf:2:1: warning: <actor> is not simulated yet: it is left out"});
}

}  // namespace
}  // namespace pongsim::sdf::test
