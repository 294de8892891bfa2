#include "sdf/readers/models/semantics_reader.hh"

#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

Loaded loadSemantics(const std::string& content) {
  return loadModel("<gz:semantics>\n" + content + "</gz:semantics><link name='l'/>", "1.12");
}

TEST(Semantics, AreReadInFull) {
  const Loaded loaded = loadSemantics(
      "<category>ROBOT</category><description>Delivers food</description><tag>mobile</tag><tag>diff_drive</tag>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(loaded.model().semantics,
            (Semantics{.category = 1, .description = "Delivers food", .tags = {"mobile", "diff_drive"}}));
  EXPECT_EQ(loadModel("<link name='l'/>").model().semantics, Semantics());
}

TEST(Semantics, HaveTheCategoriesOfSimulationInterfaces) {
  const std::vector<std::pair<std::string, int>> categories = {
      {"object", 0}, {"robot", 1}, {"Human", 2}, {"dynamic_object", 4}, {"STATIC_OBJECT", 5}};
  for (const auto& [name, number] : categories) {
    EXPECT_EQ(loadSemantics("<category>" + name + "</category>").model().semantics.category, number) << name;
  }
}

TEST(Semantics, LeaveOutWhatIsWrong) {
  const Loaded loaded =
      loadSemantics("<category>robots</category>\n<category>human</category>\n<description/>\n<tag/><tag>a</tag>");
  EXPECT_EQ(
      loaded.messages,
      (Messages{"t.sdf:4:1: warning: 'robots' is not a category of model 'm': it is left out | did you mean "
                "'robot'?",
                "t.sdf:5:1: warning: the semantics of model 'm' have more than one <category>: the first one counts",
                "t.sdf:6:1: warning: a <description> in the semantics of model 'm' is empty: it is left out",
                "t.sdf:7:1: warning: a <tag> in the semantics of model 'm' is empty: it is left out"}));
  EXPECT_EQ(loaded.model().semantics, (Semantics{.category = {}, .description = {}, .tags = {"a"}}));
}

}  // namespace
}  // namespace pongsim::sdf::test
