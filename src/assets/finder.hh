#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "assets/fuel_fetch.hh"
#include "assets/places.hh"
#include "pongsim/diagnostic.hh"

namespace pongsim::assets {

/// Finds what an address in a file names.
///
/// The address is a path, absolute or relative to the folder of the file that it stands in, to one of the resource
/// folders or to the current folder; "file://PATH"; "model://NAME" or "model://NAME/FILE", in the resource folders or
/// the current one, where "package://", as URDF writes it, means the same; or that of a model or world on a Fuel
/// server, which is looked for in the local cache, and downloaded into it where the finder may do that.
class Finder {
 public:
  /// One that has no places to look in but paths and the current folder.
  Finder() = default;
  /// @param fetch Null: nothing is downloaded.
  explicit Finder(Places places, std::shared_ptr<FuelFetch> fetch = nullptr);

  /// @param folder That of the file that the address stands in.
  /// @param position Where the address stands.
  /// @return The file or folder; nothing, and one error added, where there is none.
  std::optional<std::filesystem::path> operator()(std::string_view uri, const std::filesystem::path& folder,
                                                  const SourcePosition& position, Diagnostics& diagnostics) const;

  /// Downloads at once what of these addresses is on a Fuel server and not in the cache, where the finder may: sooner
  /// done side by side than one after the other.
  void bring(const std::vector<std::string>& addresses) const;

 private:
  Places places_;
  std::shared_ptr<FuelFetch> fetch_;
};

/// @return One that looks in these places, and downloads nothing.
Finder finderIn(Places places);

/// @return One that looks where the environment says now, and downloads what is on a Fuel server.
Finder finderFromEnvironment();

}  // namespace pongsim::assets
