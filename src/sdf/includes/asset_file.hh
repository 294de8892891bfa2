#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "assets/problem.hh"
#include "description/material.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// A file that a shape is read from.
struct AssetFile {
  /// As written in the SDF file; empty if it is not found and comes from outside (`assets::Finder`).
  std::string uri;
  /// Empty if the file does not exist.
  std::filesystem::path path;
  /// For warnings: what the file is, which element names it, and what happens without it.
  std::string kind;
  SourcePosition position;
  std::string effect;

  /// Warns that the file can't be used.
  void warn(const assets::Problem& problem, Context& context) const;
};

/// Finds the file named by a shape's `<uri>`. A missing file gives a warning, a missing `<uri>` an error.
/// @param kind "mesh"
/// @param owner "collision 'c' of link 'l'"
AssetFile findAsset(const Element& shape, const std::string& kind, const std::string& owner, bool isCollision,
                    Context& context);

/// Finds the file named by a child element, such as a texture or an animation. A missing file gives a warning, once for
/// each address.
/// @return Both fields empty if the child is missing or empty.
description::Texture readTexture(const Element& parent, std::string_view child, Context& context);

}  // namespace pongsim::sdf
