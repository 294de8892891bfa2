#include "cli/fortress/gz_types.hh"

#include <gtest/gtest.h>

namespace pongsim::cli {
namespace {

TEST(GzTypes, AreNamedAsSinceGarden) {
  const std::string text = "File: ignition/msgs/twist.proto\n.ignition.msgs.Header header = 1;\nignition.msgs.Twist";
  EXPECT_EQ(withTypeNames(text, true), "File: gz/msgs/twist.proto\n.gz.msgs.Header header = 1;\ngz.msgs.Twist");
  EXPECT_EQ(withTypeNames(text, false), text);
  EXPECT_EQ(withTypeNames("/ignition/messages", true), "/ignition/messages");
}

}  // namespace
}  // namespace pongsim::cli
