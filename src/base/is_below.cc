#include "base/is_below.hh"

#include <algorithm>
#include <system_error>

namespace pongsim::base {

bool isBelow(const std::filesystem::path& file, const std::filesystem::path& folder) {
  if (file.empty() || folder.empty()) return false;
  std::error_code error;
  // also of what is not there yet
  const std::filesystem::path real = std::filesystem::weakly_canonical(file, error);
  if (error) return false;
  const std::filesystem::path above = std::filesystem::canonical(folder, error);
  return !error && std::ranges::mismatch(above, real).in1 == above.end();
}

}  // namespace pongsim::base
