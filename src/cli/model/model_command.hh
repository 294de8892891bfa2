#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "cli/model/model_text.hh"

namespace pongsim::cli {

struct ModelOptions {
  /// "outer::inner", or the name of a nested model; empty: list the world's models.
  std::string model;
  ModelParts parts;
  bool json = false;
  /// First print the name of the world, like `ign model`.
  bool namesWorld = false;
  /// Keep printing.
  bool follows = false;
  /// With `follows`: how many times to print.
  std::optional<std::uint64_t> count;
  /// The world's name; empty: the only running one, or, if a single process runs all of them, its first one.
  std::string world;
  /// For finding the world, and for each of its answers.
  std::chrono::nanoseconds timeout = std::chrono::seconds(1);
};

/// Implements `pongsim model`.
/// @return The exit code.
int showModels(const ModelOptions& options);

}  // namespace pongsim::cli
