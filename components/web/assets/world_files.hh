#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/message.hh"

namespace pongsim::web {

/// The files that a world is drawn with: those named in its scene, and those in the folders of their models, if they
/// are of a kind that models consist of.
class WorldFiles {
 public:
  WorldFiles() = default;
  /// @param scene An ignition.msgs.Scene.
  /// @param more Paths of further files that a scene does not name, such as the skins of actors.
  explicit WorldFiles(const Message& scene, const std::vector<std::string>& more = {});

  /// @param address A path, "file://PATH", or "model://NAME/PATH" of a model from which the scene uses a file.
  /// @return The file, with all symbolic links resolved; nothing if it is not one of these, or does not exist.
  std::optional<std::filesystem::path> find(std::string_view address) const;

 private:
  /// A folder whose files are available.
  struct Folder {
    std::filesystem::path path;
    /// Whether those in subfolders are too.
    bool isDeep = false;
    auto operator<=>(const Folder&) const = default;
  };

  void addFilesOf(const Message& message);
  void addNamed(std::string_view text);
  void add(const std::filesystem::path& file);
  bool has(const std::filesystem::path& file) const;

  std::set<std::filesystem::path> files_;
  std::set<Folder> folders_;
};

}  // namespace pongsim::web
