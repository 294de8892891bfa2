#include "rendering/small_font.hh"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace pongsim::rendering {
namespace {

TEST(SmallFont, HasADifferentShapeForEachLetter) {
  std::set<SmallLetter> shapes;
  for (char32_t letter = ' '; letter <= '~'; ++letter) shapes.insert(smallLetter(letter));
  EXPECT_EQ(shapes.size(), 95U);
  EXPECT_EQ(shapes.count(smallLetter(U'\u00e9')), 0U);
  EXPECT_EQ(smallLetter(U'\u00e9'), smallLetter('\n'));
}

TEST(SmallFont, DrawsLettersUprightFromTheLeft) {
  const SmallLetter letter = smallLetter('F');
  std::string text;
  for (std::size_t row = 0; row < kLetterHeight; ++row) {
    for (const std::uint8_t column : letter) text += (column >> row & 1) != 0 ? '#' : ' ';
    text += '\n';
  }
  EXPECT_EQ(text, "#####\n#    \n#    \n#### \n#    \n#    \n#    \n");
}

}  // namespace
}  // namespace pongsim::rendering
