#pragma once

#include <string>
#include <vector>

namespace pongsim::ros2 {

/// @return One line for each row, with aligned columns separated by two spaces and no trailing spaces.
std::string alignedRows(const std::vector<std::vector<std::string>>& rows);

}  // namespace pongsim::ros2
