#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pongsim::test {

/// @return A grey PNG image of 8 bits, uncompressed.
/// @param pixels Row by row from the top.
std::string grayPng(std::size_t width, const std::vector<std::uint8_t>& pixels);

}  // namespace pongsim::test
