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
#include "sdf/frames/frame_dot.hh"
#include "sdf/text/file_text.hh"

namespace pongsim::sdf {

/// Content of an SDF file.
struct Root {
  std::vector<description::World> worlds;
  /// Models, lights and actors outside of any world, read as if they were in a world of their own.
  std::vector<description::Model> models;
  std::vector<description::Light> lights;
  std::vector<description::Actor> actors;
  /// Warnings about valid content that pongsim does not simulate, and errors if it can't be left out. They matter only
  /// if the content is simulated.
  Diagnostics unsimulated;
};

/// Reads a file and its includes. All errors and warnings are added to `diagnostics`; the result is only usable without
/// errors.
/// @param finder Finds included files.
Root loadFile(const std::filesystem::path& file, Diagnostics& diagnostics,
              const assets::Finder& finder = assets::finderFromEnvironment(), NamedBy by = NamedBy::kUser);

/// Like `loadFile`, from text.
/// @param name Used in diagnostics; its folder is that of the text.
Root loadText(std::string_view text, std::string_view name, Diagnostics& diagnostics,
              const assets::Finder& finder = assets::finderFromEnvironment());

/// Like `loadFile`, from an `<sdf>` element of another file, such as one in a `<plugin>`.
Root loadElement(const Element& sdf, Diagnostics& diagnostics,
                 const assets::Finder& finder = assets::finderFromEnvironment());

/// What happens to each `<include>` when a file is resolved.
enum class IncludeUse { kReplace, kPreserve };

/// Reads a file and its includes like `loadFile`.
/// @param use Whether each `<include>` is replaced by its content or preserved.
/// @return Its `<sdf>` element in SDF 1.9, or 1.12 if it is of a later version, with the elements that Fortress adds;
/// nothing on errors.
std::optional<Element> resolveFile(const std::filesystem::path& file, Diagnostics& diagnostics,
                                   const assets::Finder& finder = assets::finderFromEnvironment(),
                                   IncludeUse use = IncludeUse::kReplace);

/// Reads a file like `loadFile`.
/// @return The frame graph of each world, and of everything outside of worlds, as text for Graphviz; nothing on errors.
std::optional<std::string> frameGraphs(const std::filesystem::path& file, FrameGraphKind kind, Diagnostics& diagnostics,
                                       const assets::Finder& finder = assets::finderFromEnvironment());

}  // namespace pongsim::sdf
