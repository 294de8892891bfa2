// Arbitrary bytes as a PNG or JPEG file, for a texture or a heightmap. The readers must end and return an image with
// all its pixels, or a reason.

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>

#include "assets/images/gray_image.hh"
#include "assets/images/picture_file.hh"
#include "require.hh"
#include "support/temp_folder.hh"

namespace {

/// @param channels Bytes per pixel.
template <class Image>
void requireWhole(const std::variant<Image, pongsim::assets::Problem>& found, std::size_t channels) {
  if (const auto* image = std::get_if<Image>(&found)) {
    pongsim::fuzz::require(image->pixels.size() == image->width * image->height * channels);
  } else {
    pongsim::fuzz::require(!std::get<pongsim::assets::Problem>(found).text.empty());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const pongsim::test::TempFolder folder;
  const auto file = folder.write("picture", std::string_view(reinterpret_cast<const char*>(data), size));
  requireWhole(pongsim::assets::readPicture(file), 4);
  requireWhole(pongsim::assets::readGrayImage(file), 1);
  return 0;
}
