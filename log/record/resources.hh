#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "pongsim/message.hh"

namespace pongsim::log {

/// Finds the file that an address names, as "model://box/box.dae".
using Resolve = std::function<std::optional<std::filesystem::path>(const std::string&)>;

/// Calls `visit` with the address of each file that a text of SDF names in an element of its own, and puts what it
/// returns in the address's place. What is in comments is taken, too.
std::string withAddresses(std::string_view sdf, const std::function<std::string(const std::string&)>& visit);

/// Copies the files that models are made of into a recording, each below the recording's folder under its whole path,
/// as Fortress does: of a model's folder all of it, for meshes name their textures themselves.
class ResourceCopies {
 public:
  explicit ResourceCopies(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Copies a file, unless it has been.
  /// @throws Failure where it can't be.
  void add(const std::filesystem::path& file);

  /// Copies the meshes and pictures that a state names.
  /// @param step An ignition.msgs.SerializedStepMap.
  void addAllOf(const Message& step);

 private:
  void copy(const std::filesystem::path& from);

  std::filesystem::path folder_;
  std::set<std::filesystem::path> done_;
};

}  // namespace pongsim::log
