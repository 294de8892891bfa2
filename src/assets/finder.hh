#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "assets/places.hh"
#include "pongsim/diagnostic.hh"

namespace pongsim::assets {

/// Finds what an address in a file names.
///
/// The address is a path, absolute or relative to the folder of the file that it stands in, to one of the resource
/// folders or to the current folder; "file://PATH"; "model://NAME" or "model://NAME/FILE", in the resource folders or
/// the current one, where "package://", as URDF writes it, means the same; or that of a model on a Fuel server, which
/// is looked for in the local cache.
///
/// @param folder That of the file that the address stands in.
/// @param position Where the address stands.
/// @return The file or folder; nothing, and one error added, where there is none.
using Finder =
    std::function<std::optional<std::filesystem::path>(std::string_view uri, const std::filesystem::path& folder,
                                                       const SourcePosition& position, Diagnostics& diagnostics)>;

/// @return One that looks in these places.
Finder finderIn(Places places);

/// @return One that looks where the environment says now.
Finder finderFromEnvironment();

}  // namespace pongsim::assets
