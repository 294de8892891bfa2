#include "support/png_file.hh"

#include <string_view>

namespace pongsim::test {

namespace {

std::string bigEndian(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>((number >> shift) & 0xFFU);
  return bytes;
}

std::uint32_t checksum(std::string_view bytes) {
  std::uint32_t sum = 0xFFFFFFFFU;
  for (const char byte : bytes) {
    sum ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~sum;
}

std::string chunk(const std::string& kind, const std::string& content) {
  return bigEndian(static_cast<std::uint32_t>(content.size())) + kind + content + bigEndian(checksum(kind + content));
}

/// zlib's format with one block that is stored as it is, of less than 64 KiB.
std::string stored(const std::string& content) {
  const auto size = static_cast<std::uint32_t>(content.size());
  std::string stream = {'\x78', '\x01', '\x01'};
  for (const std::uint32_t number : {size, ~size}) {
    stream += static_cast<char>(number & 0xFFU);
    stream += static_cast<char>((number >> 8U) & 0xFFU);
  }
  std::uint32_t a = 1, b = 0;
  for (const char byte : content) {
    a = (a + static_cast<unsigned char>(byte)) % 65521;
    b = (b + a) % 65521;
  }
  return stream + content + bigEndian((b << 16U) | a);
}

}  // namespace

std::string grayPng(std::size_t width, const std::vector<std::uint8_t>& pixels) {
  std::string rows;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (i % width == 0) rows += '\0';
    rows += static_cast<char>(pixels[i]);
  }
  const std::string header = bigEndian(static_cast<std::uint32_t>(width)) +
                             bigEndian(static_cast<std::uint32_t>(pixels.size() / width)) +
                             std::string("\x08\0\0\0\0", 5);
  return "\x89PNG\r\n\x1A\n" + chunk("IHDR", header) + chunk("IDAT", stored(rows)) + chunk("IEND", "");
}

}  // namespace pongsim::test
