#pragma once

#include <string>
#include <string_view>

namespace pongsim::web::foxglove {

/// @return The bytes as base64, as RFC 4648 has it, with padding.
std::string base64(std::string_view bytes);

}  // namespace pongsim::web::foxglove
