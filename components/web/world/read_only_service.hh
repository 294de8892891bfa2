#pragma once

#include <string_view>

namespace pongsim::web {

/// @return Whether calls to this service change nothing, so that read-only clients may call it.
bool isReadOnlyService(std::string_view service);

}  // namespace pongsim::web
