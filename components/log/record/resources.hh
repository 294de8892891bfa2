#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "pongsim/message.hh"

namespace pongsim::log {

/// Resolves the address of a file, such as "model://box/box.dae".
using Resolve = std::function<std::optional<std::filesystem::path>(const std::string&)>;

/// Calls `visit` with the address of each file that an element of an SDF text consists of, and replaces the address by
/// the result. Also finds addresses in comments.
std::string withAddresses(std::string_view sdf, const std::function<std::string(const std::string&)>& visit);

/// Copies the files of models into a recording, each under its full path below the recording's folder, as Fortress
/// does. Copies the whole folder of a model, because meshes refer to their textures.
class ResourceCopies {
 public:
  explicit ResourceCopies(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Copies a file, unless it has been copied before.
  /// @throws Failure if that fails.
  void add(const std::filesystem::path& file);

  /// Copies the meshes and textures named in a state.
  /// @param step An ignition.msgs.SerializedStepMap.
  void addAllOf(const Message& step);

 private:
  void copy(const std::filesystem::path& from);

  std::filesystem::path folder_;
  std::set<std::filesystem::path> done_;
};

}  // namespace pongsim::log
