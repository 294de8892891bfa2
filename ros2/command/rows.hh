#pragma once

#include <string>
#include <vector>

namespace pongsim::ros2 {

/// @return A line each row, its columns below each other, two spaces between them and none at the end.
std::string alignedRows(const std::vector<std::vector<std::string>>& rows);

}  // namespace pongsim::ros2
