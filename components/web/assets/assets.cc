#include "web/assets/assets.hh"

#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "web/server/media_type.hh"

namespace pongsim::web {

void Assets::set(const void* world, WorldFiles files) {
  const std::lock_guard lock(mutex_);
  worlds_[world] = std::make_shared<const WorldFiles>(std::move(files));
}

void Assets::remove(const void* world) {
  const std::lock_guard lock(mutex_);
  worlds_.erase(world);
}

std::optional<std::filesystem::path> Assets::find(std::string_view address) const {
  std::vector<std::shared_ptr<const WorldFiles>> all;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [world, files] : worlds_) all.push_back(files);
  }
  for (const auto& files : all) {
    if (auto found = files->find(address)) return found;
  }
  return {};
}

Asset Assets::fetch(std::string_view address) const {
  const std::optional<std::filesystem::path> file = find(address);
  if (!file) return {{}, {}, "no world uses a file '" + std::string(address) + "'"};
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(*file, error);
  if (!error && size > kLargest)
    return {{}, {}, "'" + std::string(address) + "' is larger than " + std::to_string(kLargest) + " bytes"};
  std::ifstream stream(*file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (error || !stream) return {{}, {}, "'" + std::string(address) + "' can't be read"};
  return {std::move(bytes), std::string(mediaType(*file)), {}};
}

}  // namespace pongsim::web
