#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/message.hh"

namespace pongsim::web {

/// The files that a world is drawn with: those that its scene names, and what lies in the folders of their models, of
/// the kinds that models consist of.
class WorldFiles {
 public:
  WorldFiles() = default;
  /// @param scene An ignition.msgs.Scene.
  /// @param more Paths of other files, such as the skins of actors, which a scene does not name.
  explicit WorldFiles(const Message& scene, const std::vector<std::string>& more = {});

  /// @param address A path, "file://PATH" or "model://NAME/PATH", of a model that the scene has a file of.
  /// @return The file, with all links followed; nothing where it is none of these, or not there.
  std::optional<std::filesystem::path> find(std::string_view address) const;

 private:
  /// A folder, of which the files may be had.
  struct Folder {
    std::filesystem::path path;
    /// Whether those in folders below, too.
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
