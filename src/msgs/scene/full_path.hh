#pragma once

#include <filesystem>
#include <string>

namespace pongsim::msgs {

/// @param named What names a file by its `uri` and `file`: a mesh, a texture, an actor's skin.
/// @return The full path, or what stands in the description where it leads nowhere.
template <class Named>
std::string pathOf(const Named& named) {
  return named.file.empty() ? named.uri : std::filesystem::absolute(named.file).lexically_normal().string();
}

}  // namespace pongsim::msgs
