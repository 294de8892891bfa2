#pragma once

#include <string>

namespace pongsim::web::gz {

/// @return All message types and enumerations of ignition.msgs, as one .proto file.
std::string definitions();

}  // namespace pongsim::web::gz
