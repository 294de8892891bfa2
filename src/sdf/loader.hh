#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "assets/finder.hh"
#include "description/world.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"
#include "sdf/frame_dot.hh"

namespace pongsim::sdf {

/// What an SDF file describes.
struct Root {
  std::vector<description::World> worlds;
  /// Those outside of any world, as if they stood in one of their own.
  std::vector<description::Model> models;
  std::vector<description::Light> lights;
  std::vector<description::Actor> actors;
  /// Warnings of what the file says well and pongsim does not simulate, and errors where it can't be left out: of no
  /// concern to those who only read.
  Diagnostics unsimulated;
};

/// Reads a file and all that it includes. All that is wrong with them is added to `diagnostics`, in one go; what the
/// result holds is of use only if there was no error.
/// @param finder Finds the files that are included.
Root loadFile(const std::filesystem::path& file, Diagnostics& diagnostics,
              const assets::Finder& finder = assets::finderFromEnvironment());

/// As `loadFile`, from text.
/// @param name Stands in the diagnostics; its folder is that of the text.
Root loadText(std::string_view text, std::string_view name, Diagnostics& diagnostics,
              const assets::Finder& finder = assets::finderFromEnvironment());

/// As `loadFile`, from an `<sdf>` element of another file, as one that stands in a `<plugin>`.
Root loadElement(const Element& sdf, Diagnostics& diagnostics,
                 const assets::Finder& finder = assets::finderFromEnvironment());

/// What becomes of each `<include>` where a file is resolved.
enum class IncludeUse { kReplace, kPreserve };

/// Reads a file and all that it includes as `loadFile` does.
/// @param use What is included stands in place of each `<include>`, or that stays.
/// @return Its `<sdf>` element, of SDF 1.9, with the elements that Fortress adds; nothing where there was an error.
std::optional<Element> resolveFile(const std::filesystem::path& file, Diagnostics& diagnostics,
                                   const assets::Finder& finder = assets::finderFromEnvironment(),
                                   IncludeUse use = IncludeUse::kReplace);

/// Reads a file as `loadFile` does.
/// @return The graph of the frames of each world in it, and of what stands in none, as text for Graphviz; nothing where
/// there was an error.
std::optional<std::string> frameGraphs(const std::filesystem::path& file, FrameGraphKind kind, Diagnostics& diagnostics,
                                       const assets::Finder& finder = assets::finderFromEnvironment());

}  // namespace pongsim::sdf
