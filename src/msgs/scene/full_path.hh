#pragma once

#include <filesystem>
#include <string>

namespace pongsim::msgs {

/// @param named Something with a `uri` and a `file`: a mesh, a texture, an actor's skin.
/// @return The full path; if there is no such file, the `uri` from the description.
template <class Named>
std::string pathOf(const Named& named) {
  return named.file.empty() ? named.uri : std::filesystem::absolute(named.file).lexically_normal().string();
}

}  // namespace pongsim::msgs
