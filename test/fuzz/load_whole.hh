#pragma once

#include <cstdlib>
#include <string_view>

#include "pongsim/diagnostic.hh"
#include "sdf/loader.hh"

namespace pongsim::fuzz {

/// Loads a file with any content. The loader must end, and report what is wrong.
inline void loadWhole(std::string_view text, std::string_view name) {
  Diagnostics diagnostics;
  // without search paths, so that the result does not depend on the machine's files
  const sdf::Root root = sdf::loadText(text, name, diagnostics, assets::finderIn({}));
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (format(diagnostic).empty()) std::abort();
  }
  const bool isEmpty = root.worlds.empty() && root.models.empty() && root.lights.empty() && root.actors.empty();
  if (!diagnostics.hasErrors() && isEmpty) std::abort();
}

}  // namespace pongsim::fuzz
