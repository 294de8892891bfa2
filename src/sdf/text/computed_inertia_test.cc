#include "sdf/text/computed_inertia.hh"

#include <gtest/gtest.h>

#include "sdf/text/print.hh"
#include "support/sdf/load_support.hh"
#include "support/temp_folder.hh"

namespace pongsim::sdf::test {
namespace {

TEST(ComputedInertia, IsWrittenWhereTheFileHasItComputed) {
  const ::pongsim::test::TempFolder folder;
  // a box of 2 x 4 x 6 m with 500 kg/m^3: m = 24000 kg, Ixx = m (4^2 + 6^2) / 12
  const std::string box =
      "<inertial auto='true'><density>500</density><pose>9 9 9 0 0 1</pose></inertial>"
      "<collision name='c'><pose>1 0 0 0 0 0</pose><geometry><box><size>2 4 6</size></box></geometry></collision>";
  const auto file = folder.write("a.sdf", "<sdf version='1.11'><world name='w'><model name='m'><link name='l'>" + box +
                                              "</link><link name='own'><inertial><mass>7</mass></inertial></link>"
                                              "<model name='inner'><link name='l'>" +
                                              box + "</link></model></model></world></sdf>");
  Diagnostics diagnostics;
  std::optional<Element> root = resolveFile(file, diagnostics);
  ASSERT_TRUE(root.has_value());
  writeComputedInertia(*root, loadFile(file, diagnostics));
  ASSERT_FALSE(diagnostics.hasErrors());
  const Element& model = *root->child("world")->child("model");
  const Element& inner = *model.child("model");
  for (const Element* link : {model.child("link"), inner.child("link")}) {
    const Element& inertial = *link->child("inertial");
    EXPECT_EQ(inertial.attributeOr("auto", ""), "true");
    EXPECT_EQ(inertial.child("pose")->text, "1 0 0 0 0 0");
    EXPECT_DOUBLE_EQ(inertial.find<double>("mass").value(), 24000);
    const Element& moments = *inertial.child("inertia");
    EXPECT_NEAR(moments.find<double>("ixx").value(), 104000, 1e-6);
    EXPECT_NEAR(moments.find<double>("iyy").value(), 80000, 1e-6);
    EXPECT_NEAR(moments.find<double>("izz").value(), 40000, 1e-6);
    EXPECT_NEAR(moments.find<double>("ixy").value(), 0, 1e-6);
  }
  EXPECT_EQ(model.childrenNamed("link").at(1)->child("inertial")->child("mass")->text, "7");
}

}  // namespace
}  // namespace pongsim::sdf::test
