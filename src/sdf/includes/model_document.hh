#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"
#include "pongsim/files/urdf_source.hh"

namespace pongsim::sdf {

/// A file that describes something.
struct ModelDocument {
  /// The `<sdf>` element.
  Element sdf;
  /// What it was made from, where the file is URDF; else null.
  std::shared_ptr<const UrdfSource> urdf;
};

/// As `parseDocument`, for a file that describes something: an `<sdf>`, or a `<robot>` in URDF, which becomes one.
/// @return Nothing, and errors added, where there is neither.
std::optional<ModelDocument> parseModelDocument(std::string_view text, std::shared_ptr<const std::string> file,
                                                Diagnostics& diagnostics);

}  // namespace pongsim::sdf
