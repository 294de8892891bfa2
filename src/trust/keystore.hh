#pragma once

#include <filesystem>
#include <string>

namespace pongsim::trust {

/// @return The name in the keystore of the identity in that folder: "/robot/arm" for KEYSTORE/enclaves/robot/arm.
std::string nameOf(const std::filesystem::path& folder);

}  // namespace pongsim::trust
