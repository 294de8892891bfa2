#include "web/foxglove/base64.hh"

#include <cstddef>
#include <cstdint>

namespace pongsim::web::foxglove {

std::string base64(std::string_view bytes) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t place) {
      return place < bytes.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[place])) : 0U;
    };
    const std::uint32_t three = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    for (std::size_t letter = 0; letter < 4; ++letter) {
      const bool isThere = i + letter <= bytes.size();
      text += isThere ? kLetters[three >> (18 - 6 * letter) & 63] : '=';
    }
  }
  return text;
}

}  // namespace pongsim::web::foxglove
