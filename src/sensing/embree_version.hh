#pragma once

#include <string>

namespace pongsim::sensing {

/// @return "3.13.5", of the library that scenes use; "not installed" where there is none.
std::string embreeVersion();

}  // namespace pongsim::sensing
