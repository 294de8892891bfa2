#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"
#include "pongsim/files/urdf_source.hh"

namespace pongsim::sdf {

/// A parsed model file.
struct ModelDocument {
  /// The `<sdf>` element.
  Element sdf;
  /// The URDF source if the file is URDF; else null.
  std::shared_ptr<const UrdfSource> urdf;
};

/// Like `parseDocument`, for a model file: an `<sdf>`, or a URDF `<robot>`, which is converted.
/// @return Nothing, with errors, if it is neither.
std::optional<ModelDocument> parseModelDocument(std::string_view text, std::shared_ptr<const std::string> file,
                                                Diagnostics& diagnostics);

}  // namespace pongsim::sdf
