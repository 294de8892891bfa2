#include "ros2/types/sha256.hh"

#include <openssl/sha.h>

#include <array>

namespace pongsim::ros2 {

std::string sha256(std::string_view text) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> hash{};
  SHA256(reinterpret_cast<const unsigned char*>(text.data()), text.size(), hash.data());
  std::string digits;
  for (const unsigned char byte : hash) {
    for (const int shift : {4, 0}) digits += "0123456789abcdef"[(byte >> shift) & 0xf];
  }
  return digits;
}

}  // namespace pongsim::ros2
