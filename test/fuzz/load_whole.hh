#pragma once

#include <cstdlib>
#include <string_view>

#include "pongsim/diagnostic.hh"
#include "sdf/loader.hh"

namespace pongsim::fuzz {

/// Loads a file of any content. Whatever it is, the loader ends, and says what is wrong.
inline void loadWhole(std::string_view text, std::string_view name) {
  Diagnostics diagnostics;
  // nothing is found: what is on the machine has no part in it
  const sdf::Root root = sdf::loadText(text, name, diagnostics, assets::finderIn({}));
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (format(diagnostic).empty()) std::abort();
  }
  const bool isEmpty = root.worlds.empty() && root.models.empty() && root.lights.empty() && root.actors.empty();
  if (!diagnostics.hasErrors() && isEmpty) std::abort();
}

}  // namespace pongsim::fuzz
