#include "sdf/schema/rounding.hh"

#include <gtest/gtest.h>

#include "sdf/text/document.hh"
#include "sdf/text/print.hh"
#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

std::string rounded(const std::string& text, int digits) {
  Diagnostics diagnostics;
  std::optional<Element> root = parseDocument(text, std::make_shared<const std::string>("t.sdf"), diagnostics);
  if (!root) return "";
  roundNumbers(*root, digits);
  return printDocument(*root);
}

TEST(Rounding, IsOfNumbersWithAFractionAlone) {
  const std::string text = rounded(
      "<sdf version='1.9'><world name='1.23456'><gravity>0 0 -9.80665</gravity>"
      "<model name='m'><pose relative_to='f'>1.23456 0 0 0 0 1.570796326</pose><link name='l'>"
      "<inertial><mass>12.3456</mass></inertial>"
      "<collision name='c'><max_contacts>12345</max_contacts>"
      "<geometry><mesh><uri>1.23456</uri></mesh></geometry></collision></link>"
      "<plugin name='p' filename='f'><pose>1.23456</pose></plugin></model></world></sdf>",
      3);
  for (const char* kept : {"<world name=\"1.23456\">", "<uri>1.23456</uri>", "<max_contacts>12345</max_contacts>",
                           "<pose>1.23456</pose>"}) {
    EXPECT_NE(text.find(kept), std::string::npos) << kept << text;
  }
  for (const char* changed : {"<gravity>0 0 -9.81</gravity>", ">1.23 0 0 0 0 1.57</pose>", "<mass>12.3</mass>"}) {
    EXPECT_NE(text.find(changed), std::string::npos) << changed << text;
  }
}

TEST(Rounding, LeavesWhatIsNoNumber) {
  EXPECT_NE(rounded("<sdf version='1.9'><world name='w'><gravity>down 1.23456</gravity></world></sdf>", 3)
                .find("down 1.23456"),
            std::string::npos);
}

}  // namespace
}  // namespace pongsim::sdf::test
