#include "load_support.hh"

namespace pongsim::sdf::test {
namespace {

TEST(Unsimulated, KindsAreNamedOnce) {
  EXPECT_EQ(loadWorld("<actor name='a'/><actor name='b'/>").messages,
            Messages{"t.sdf:2:1: warning: <actor> is not simulated yet: it is left out"});
}

}  // namespace
}  // namespace pongsim::sdf::test
