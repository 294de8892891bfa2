#include "assets/images/tga_image.hh"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "support/temp_folder.hh"

namespace pongsim::assets {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// @param description Bits of opacity, and 16: from the right, 32: from the top.
std::string tga(unsigned kind, unsigned width, unsigned height, unsigned bits, unsigned description,
                const std::string& pixels, const std::string& palette = "", unsigned paletteBits = 0) {
  const auto length = palette.empty() ? 0 : palette.size() * 8 / paletteBits;
  std::string header(18, '\0');
  header[0] = 2;
  header[1] = palette.empty() ? 0 : 1;
  header[2] = static_cast<char>(kind);
  header[5] = static_cast<char>(length);
  header[7] = static_cast<char>(paletteBits);
  header[12] = static_cast<char>(width);
  header[14] = static_cast<char>(height);
  header[16] = static_cast<char>(bits);
  header[17] = static_cast<char>(description);
  return header + "id" + palette + pixels;
}

Bytes tgaPixels(const std::string& content) {
  const auto read = readTga(content, 100);
  const auto* picture = std::get_if<Picture>(&read);
  if (picture == nullptr) ADD_FAILURE() << std::get<Problem>(read).text;
  return picture == nullptr ? Bytes() : picture->pixels;
}

TEST(TgaImage, HasTheColoursOfEachKind) {
  EXPECT_EQ(tgaPixels(tga(2, 2, 1, 24, 32, "\1\2\3\4\5\6")), (Bytes{3, 2, 1, 255, 6, 5, 4, 255}));
  EXPECT_EQ(tgaPixels(tga(2, 1, 1, 32, 32 + 8, "\1\2\3\4")), (Bytes{3, 2, 1, 4}));
  // without bits of opacity, the fourth byte is none
  EXPECT_EQ(tgaPixels(tga(2, 1, 1, 32, 32, "\1\2\3\4")), (Bytes{3, 2, 1, 255}));
  // 5 bits each: red 31, green 0, blue 31
  EXPECT_EQ(tgaPixels(tga(2, 1, 1, 16, 32, "\x1F\x7C")), (Bytes{255, 0, 255, 255}));
  EXPECT_EQ(tgaPixels(tga(3, 2, 1, 8, 32, "\7\x9")), (Bytes{7, 7, 7, 255, 9, 9, 9, 255}));
  EXPECT_EQ(tgaPixels(tga(1, 2, 1, 8, 32, std::string("\1\0", 2), "\1\2\3\4\5\6", 24)),
            (Bytes{6, 5, 4, 255, 3, 2, 1, 255}));
}

TEST(TgaImage, IsReadFromTheCornerWhereItBegins) {
  // 2 by 2 pixels, 1 to 4 from the upper left
  const Bytes upright{1, 1, 1, 255, 2, 2, 2, 255, 3, 3, 3, 255, 4, 4, 4, 255};
  EXPECT_EQ(tgaPixels(tga(3, 2, 2, 8, 32, "\1\2\3\4")), upright);
  EXPECT_EQ(tgaPixels(tga(3, 2, 2, 8, 0, "\3\4\1\2")), upright);
  EXPECT_EQ(tgaPixels(tga(3, 2, 2, 8, 32 + 16, "\2\1\4\3")), upright);
}

TEST(TgaImage, HasRunsAcrossRows) {
  // three times 5, then 6, 7 and 8 as they are
  EXPECT_EQ(tgaPixels(tga(11, 2, 3, 8, 32, "\x82\5\2\6\7\x8")),
            (Bytes{5, 5, 5, 255, 5, 5, 5, 255, 5, 5, 5, 255, 6, 6, 6, 255, 7, 7, 7, 255, 8, 8, 8, 255}));
  EXPECT_EQ(tgaPixels(tga(10, 2, 1, 24, 32, "\x81\1\2\3")), (Bytes{3, 2, 1, 255, 3, 2, 1, 255}));
}

TEST(TgaImage, IsRefusedWhenItLies) {
  for (const std::string& content :
       {tga(2, 2, 1, 24, 32, "\1\2\3\4\5"), tga(11, 2, 1, 8, 32, "\x82"), tga(11, 2, 1, 8, 32, ""),
        tga(1, 1, 1, 8, 32, "\2", "\1\2\3\4\5\6", 24), tga(3, 20, 20, 8, 32, std::string(400, 'x')),
        tga(1, 1, 1, 8, 32, "", "\1\2\3", 24).substr(0, 20)}) {
    EXPECT_TRUE(looksLikeTga(content));
    const auto read = readTga(content, 100);
    ASSERT_TRUE(std::holds_alternative<Problem>(read));
    EXPECT_EQ(std::get<Problem>(read).text.find("can't be read as a TGA image: "), 0U);
  }
  for (const std::string& content :
       {std::string(), std::string(17, '\0'), tga(2, 0, 1, 24, 0, ""), tga(4, 1, 1, 24, 0, "abc"),
        tga(3, 1, 1, 24, 0, "abc"), std::string("no picture, but a long text")}) {
    EXPECT_FALSE(looksLikeTga(content));
    EXPECT_TRUE(std::holds_alternative<Problem>(readTga(content, 100)));
  }
}

TEST(TgaImage, IsReadFromAFile) {
  const pongsim::test::TempFolder folder;
  const auto read = readPicture(folder.write("p.tga", tga(2, 1, 1, 24, 32, "\1\2\3")));
  ASSERT_TRUE(std::holds_alternative<Picture>(read));
  EXPECT_EQ(std::get<Picture>(read).pixels, (Bytes{3, 2, 1, 255}));
}

}  // namespace
}  // namespace pongsim::assets
