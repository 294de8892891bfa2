#include "sim/plugin_elements.hh"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pongsim::sim {
namespace {

description::Plugin plugin(const std::string& filename, const std::string& className, const std::string& child) {
  description::Plugin made;
  made.filename = filename;
  made.className = className;
  made.sdf.name = "plugin";
  made.sdf.children.emplace_back().name = child;
  return made;
}

TEST(PluginElements, JoinWhatIsSaidOfOneSystem) {
  std::vector<description::Plugin> more{plugin("libpongsim-web-system.so", "pongsim::Web", "port"),
                                        plugin("pongsim-ros2-system", "pongsim::Ros2", "domain")};
  const description::Plugin found = joined(plugin("pongsim-web-system", "Web", "title"), more);
  ASSERT_EQ(found.sdf.children.size(), 2U);
  // of several child elements of one name the first is used: the one given by the program
  EXPECT_EQ(found.sdf.children[0].name, "port");
  EXPECT_EQ(found.sdf.children[1].name, "title");
  ASSERT_EQ(more.size(), 1U);
  EXPECT_EQ(more[0].className, "pongsim::Ros2");
}

}  // namespace
}  // namespace pongsim::sim
