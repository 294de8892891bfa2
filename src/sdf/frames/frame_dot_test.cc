#include "sdf/frames/frame_dot.hh"

#include "support/sdf/load_support.hh"
#include "support/temp_folder.hh"

namespace pongsim::sdf::test {
namespace {

std::string graphs(const std::string& content, FrameGraphKind kind) {
  const pongsim::test::TempFolder folder;
  Diagnostics diagnostics;
  const auto file = folder.write("a.sdf", "<sdf version='1.9'>" + content + "</sdf>");
  return frameGraphs(file, kind, diagnostics, assets::finderIn({})).value_or("errors");
}

const std::string kWorld =
    "<world name='w'><frame name='f'><pose>1 2 3 0 0 0</pose></frame><model name='m'>"
    "<pose relative_to='f'>1 0 0 0 0 1.5</pose><link name='a'/><link name='b'><pose>0 0 1 0 0 0</pose></link>"
    "<joint name='j' type='fixed'><parent>a</parent><child>b</child></joint><frame name='g' attached_to='j'/>"
    "<model name='in' placement_frame='y'><link name='x'/><link name='y'><pose>0 1 0 0 0 0</pose></link></model>"
    "</model></world>";

// The nodes and arrows are those of libsdformat's `ign sdf -g`, in another order.

TEST(FrameDot, AttachesAStaticModelToNoLink) {
  const std::string dot =
      graphs("<world name='w'><model name='m'><static>true</static><link name='a'/><frame name='f'/></model></world>",
             FrameGraphKind::kFrame);
  EXPECT_EQ(dot.find("2 -> 3"), std::string::npos) << dot;
  EXPECT_NE(dot.find("1 -> 2"), std::string::npos) << dot;
  EXPECT_NE(dot.find("4 -> 2"), std::string::npos) << dot;
}

TEST(FrameDot, ShowsWhatFramesAreAttachedTo) {
  EXPECT_EQ(graphs(kWorld, FrameGraphKind::kFrame),
            "digraph {\n"
            "  0 [label=\"world\"];\n"
            "  1 [label=\"f\"];\n"
            "  2 [label=\"m\"];\n"
            "  3 [label=\"m::__model__\"];\n"
            "  4 [label=\"m::a\"];\n"
            "  5 [label=\"m::b\"];\n"
            "  6 [label=\"m::j\"];\n"
            "  7 [label=\"m::g\"];\n"
            "  8 [label=\"m::in\"];\n"
            "  9 [label=\"m::in::__model__\"];\n"
            "  10 [label=\"m::in::x\"];\n"
            "  11 [label=\"m::in::y\"];\n"
            "  1 -> 0;\n"
            "  2 -> 3;\n"
            "  3 -> 4;\n"
            "  6 -> 5;\n"
            "  7 -> 6;\n"
            "  8 -> 9;\n"
            "  9 -> 10;\n"
            "}\n");
}

TEST(FrameDot, ShowsWhatFramesAreMeasuredIn) {
  const std::string text = graphs(kWorld, FrameGraphKind::kPose);
  EXPECT_EQ(text.substr(text.find("->") - 4),
            "  0 -> 1 [label=\"0 0 0 0 0 0\"];\n"
            "  1 -> 2 [label=\"1 2 3 0 0 0\"];\n"
            "  3 -> 4 [label=\"0 0 0 0 0 0\"];\n"
            "  4 -> 5 [label=\"0 0 0 0 0 0\"];\n"
            "  4 -> 6 [label=\"0 0 1 0 0 0\"];\n"
            "  6 -> 7 [label=\"0 0 0 0 0 0\"];\n"
            "  7 -> 8 [label=\"0 0 0 0 0 0\"];\n"
            "  9 -> 10 [label=\"0 0 0 0 0 0\"];\n"
            "  10 -> 11 [label=\"0 0 0 0 0 0\"];\n"
            "  10 -> 12 [label=\"0 1 0 0 0 0\"];\n"
            "  4 -> 9 [label=\"0 -1 0 0 0 0\"];\n"
            "  2 -> 3 [label=\"1 0 0 0 0 1.5\"];\n"
            "}\n");
}

TEST(FrameDot, ShowsModelsThatStandInNoWorldAndQuotesNames) {
  const std::string text =
      graphs("<world name='w'/><model name='a\\&quot;b'><link name='l'/></model>", FrameGraphKind::kPose);
  EXPECT_EQ(text.substr(0, text.find("1 [")), "digraph {\n  0 [label=\"__root__\"];\n  ");
  EXPECT_NE(text.find("}\ndigraph {\n  0 [label=\"__root__\"];\n  1 [label=\"a\\\\\\\"b\"];\n"), std::string::npos)
      << text;
}

TEST(FrameDot, IsNotThereForAFileWithErrors) { EXPECT_EQ(graphs("<world/>", FrameGraphKind::kFrame), "errors"); }

}  // namespace
}  // namespace pongsim::sdf::test
