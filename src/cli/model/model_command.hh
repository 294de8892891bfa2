#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "cli/model/model_text.hh"

namespace pongsim::cli {

struct ModelOptions {
  /// "outer::inner", or the name of one nested somewhere; empty: the models of the world are listed.
  std::string model;
  ModelParts parts;
  bool json = false;
  /// Says first which world is asked, as `ign model` does.
  bool namesWorld = false;
  /// Goes on printing.
  bool follows = false;
  /// With `follows`: end after so many times.
  std::optional<std::uint64_t> count;
  /// The world's name; empty: the only one that runs, or the first one of the process that runs all.
  std::string world;
  /// For finding the world, and for each of its answers.
  std::chrono::nanoseconds timeout = std::chrono::seconds(1);
};

/// What `pongsim model` does.
/// @return The exit code.
int showModels(const ModelOptions& options);

}  // namespace pongsim::cli
