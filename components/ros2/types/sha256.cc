#include "ros2/types/sha256.hh"

#include <openssl/evp.h>

#include <array>
#include <stdexcept>

namespace pongsim::ros2 {

std::string sha256(std::string_view text) {
  std::array<unsigned char, 32> hash{};
  if (EVP_Digest(text.data(), text.size(), hash.data(), nullptr, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("OpenSSL can't compute a SHA-256");
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string digits;
  for (const unsigned char byte : hash) digits += {kDigits[byte >> 4U], kDigits[byte & 15U]};
  return digits;
}

}  // namespace pongsim::ros2
