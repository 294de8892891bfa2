#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "assets/problem.hh"
#include "description/material.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// The file that a shape is made of.
struct AssetFile {
  /// As it stands in the file.
  std::string uri;
  /// Empty where it is not there.
  std::filesystem::path path;
  /// For warnings: what it is, where it is named, and what follows if it is of no use.
  std::string kind;
  SourcePosition position;
  std::string effect;

  /// Warns that the file is of no use.
  void warn(const assets::Problem& problem, Context& context) const;
};

/// Finds what the `<uri>` of a shape names. A file that is not there is a warning, no `<uri>` an error.
/// @param kind "mesh"
/// @param owner "collision 'c' of link 'l'"
AssetFile findAsset(const Element& shape, const std::string& kind, const std::string& owner, bool isCollision,
                    Context& context);

/// Finds what an element's child names: a texture, an animation. A file that is not there is a warning, once an
/// address.
/// @return Both empty where the child is not there or names nothing.
description::Texture readTexture(const Element& parent, std::string_view child, Context& context);

}  // namespace pongsim::sdf
