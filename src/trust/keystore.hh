#pragma once

#include <filesystem>
#include <string>

namespace pongsim::trust {

/// @return What the keystore calls the identity in that folder: "/robot/arm" of KEYSTORE/enclaves/robot/arm.
std::string nameOf(const std::filesystem::path& folder);

}  // namespace pongsim::trust
