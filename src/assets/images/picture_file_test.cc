#include "assets/images/picture_file.hh"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "support/png_file.hh"
#include "support/temp_folder.hh"

namespace pongsim::assets {
namespace {

TEST(PictureFile, GivesBackWhatWasWritten) {
  const pongsim::test::TempFolder folder;
  const std::vector<std::uint8_t> pixels{255, 0, 1, 2, 3, 4};
  ASSERT_FALSE(writePicture(folder.path() / "p.png", 2, 1, pixels));
  const auto read = readPicture(folder.path() / "p.png");
  const auto* picture = std::get_if<Picture>(&read);
  ASSERT_NE(picture, nullptr);
  EXPECT_EQ(picture->width, 2U);
  EXPECT_EQ(picture->height, 1U);
  EXPECT_EQ(picture->pixels, (std::vector<std::uint8_t>{255, 0, 1, 255, 2, 3, 4, 255}));
}

TEST(PictureFile, TellsWhatIsWrong) {
  const pongsim::test::TempFolder folder;
  for (const auto& [content, problem] : {std::pair("no picture", "is not a PNG, JPEG, TGA or BMP image"),
                                         std::pair("", "is not a PNG, JPEG, TGA or BMP image"),
                                         std::pair("\x89PNG and no more", "can't be read as a PNG image: "),
                                         std::pair("\xFF\xD8\xFF and no more", "can't be read as a JPEG image: ")}) {
    const auto text = readPicture(folder.write("t.png", content));
    ASSERT_TRUE(std::holds_alternative<Problem>(text));
    EXPECT_EQ(std::get<Problem>(text).text.find(problem), 0U) << std::get<Problem>(text).text;
  }
  EXPECT_EQ(std::get<Problem>(readPicture(folder.path() / "gone.png")).text, "no such file");
  EXPECT_EQ(std::get<Problem>(readPicture("/dev/zero")).text, "is a device, not a file");
  // a header that claims 10,000 x 10,000 pixels: refused before decoding
  std::string large = pongsim::test::grayPng(1, {0});
  for (const std::size_t at : {16U, 20U}) large.replace(at, 4, std::string("\0\0\x27\x10", 4));
  const auto refused = readPicture(folder.write("large.png", large));
  ASSERT_TRUE(std::holds_alternative<Problem>(refused));
  EXPECT_TRUE(writePicture(folder.path() / "nowhere" / "p.png", 1, 1, std::vector<std::uint8_t>(3)));
}

}  // namespace
}  // namespace pongsim::assets
