#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/message.hh"

namespace pongsim::web {

/// The files that a world is drawn with, if they are of a kind that models consist of. Of the world's own models: those
/// named in its scene, and those in the folders of their models. Of models that a request inserted, which could name
/// any file: only what lies in the folders of worlds and models.
class WorldFiles {
 public:
  WorldFiles() = default;
  /// @param scene An ignition.msgs.Scene.
  /// @param more Paths of further files that a scene does not name, such as the skins of actors.
  explicit WorldFiles(const Message& scene, const std::vector<std::string>& more = {});

  /// Adds the files of inserted models: those that the scene names, and those in model folders (with `model.config`).
  /// @param scene An ignition.msgs.Scene.
  /// @param folders In which these files and model folders must lie.
  /// @return The named files that were not added because they lie elsewhere.
  std::vector<std::string> addInserted(const Message& scene, const std::vector<std::filesystem::path>& folders);

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

  void add(const std::filesystem::path& file);
  bool has(const std::filesystem::path& file) const;

  std::set<std::filesystem::path> files_;
  std::set<Folder> folders_;
};

}  // namespace pongsim::web
