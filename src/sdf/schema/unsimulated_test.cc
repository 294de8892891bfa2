#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

TEST(Unsimulated, KindsAreNamedOnce) {
  EXPECT_EQ(loadWorld("<population name='a'/><population name='b'/>").messages,
            Messages{"t.sdf:2:1: warning: <population> is not simulated yet: it is left out"});
}

}  // namespace
}  // namespace pongsim::sdf::test
