#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

TEST(Plugin, KeepsItsWholeTree) {
  const Loaded loaded = loadWorld(
      "<plugin filename='libx.so' name='n::X'>\n  <any ns:attr='1'><thing>text</thing></any>\n  <any/>\n</plugin>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Plugin& plugin = loaded.world().plugins.at(0);
  EXPECT_EQ(plugin.filename, "libx.so");
  EXPECT_EQ(plugin.className, "n::X");
  EXPECT_EQ(plugin.sdf.childrenNamed("any").size(), 2U);
  EXPECT_EQ(plugin.sdf.child("any")->child("thing")->text, "text");
  EXPECT_EQ(plugin.sdf.child("any")->position.line, 3);
  EXPECT_EQ(plugin.sdf.child("any")->position.column, 3);
}

TEST(Plugin, NeedsFilenameAndName) {
  EXPECT_EQ(
      loadWorld("<plugin/>").messages,
      (Messages{
          "t.sdf:2:1: error: a plugin of world 'w' has no filename | write <plugin filename=\"...\" name=\"...\">",
          "t.sdf:2:1: error: a plugin of world 'w' has no name | its name is that of the class in the library, such as "
          "'ignition::gazebo::systems::Physics'"}));
}

}  // namespace
}  // namespace pongsim::sdf::test
