#pragma once

#include <string>
#include <string_view>

namespace pongsim::ros2 {

/// @return SHA-256 (FIPS 180-4) of the text, as 64 hexadecimal digits.
/// @throws std::runtime_error if OpenSSL fails.
std::string sha256(std::string_view text);

}  // namespace pongsim::ros2
