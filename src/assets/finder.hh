#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "assets/fuel_fetch.hh"
#include "assets/places.hh"
#include "pongsim/diagnostic.hh"

namespace pongsim::assets {

/// Finds the file or folder that an address in a file refers to.
///
/// An address is one of these: a path, either absolute or relative to the folder of the file with the address, to a
/// resource folder, or to the current folder; "file://PATH"; "model://NAME" or "model://NAME/FILE", in the resource
/// folders or the current one, with "package://", as URDF writes it, meaning the same; or the address of a model or
/// world on a Fuel server, which is looked for in the local cache, and downloaded if the finder is allowed to.
///
/// What comes from outside (models that a request inserts, files from a Fuel server) is confined: it finds only what
/// lies in certain folders, and is not told whether anything else exists.
class Finder {
 public:
  /// Finds paths and files in the current folder only.
  Finder() = default;
  /// @param fetch Null: nothing is downloaded.
  explicit Finder(Places places, std::shared_ptr<FuelFetch> fetch = nullptr);

  /// @param folder Folder of the file with the address.
  /// @param position Position of the address in that file.
  /// @return The file or folder; nothing, with one error, if there is none.
  std::optional<std::filesystem::path> operator()(std::string_view uri, const std::filesystem::path& folder,
                                                  const SourcePosition& position, Diagnostics& diagnostics) const;

  /// Where models from outside may read, beside the Fuel cache.
  struct Reach {
    /// Folders that the user has set. What links in them lead to is allowed, too: only the user can have made them, as
    /// `colcon build --symlink-install` does.
    std::vector<std::filesystem::path> folders;
    /// Folder of the world, which may be one where everybody can make links, such as /tmp: they are followed first.
    std::filesystem::path world;
  };

  /// @return This finder for models from outside: it finds only what lies within reach and in the Fuel cache.
  Finder confinedTo(Reach reach) const;
  /// @param folder Folder of a file.
  /// @return Whether what that file names is confined, and it may write nothing.
  bool isConfined(const std::filesystem::path& folder) const;
  /// @return Whether a file in `folder` may name this file or folder.
  bool mayRead(const std::filesystem::path& file, const std::filesystem::path& folder) const;

  /// Downloads those addresses that are on a Fuel server and not in the cache, if allowed: in parallel, so faster than
  /// one by one.
  void bring(const std::vector<std::string>& addresses) const;

 private:
  Places places_;
  std::shared_ptr<FuelFetch> fetch_;
  /// Where it finds something if it is confined.
  std::optional<Reach> reach_;
  /// Of folders that were asked about.
  mutable std::map<std::filesystem::path, bool> areFromServer_;
};

/// @return A finder for these places that downloads nothing.
Finder finderIn(Places places);

/// @return A finder for the places set in the environment, which downloads from Fuel servers.
Finder finderFromEnvironment();

}  // namespace pongsim::assets
