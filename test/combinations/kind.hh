#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pongsim::test {

/// A model of a kind of world.
struct KindModel {
  std::string name;
  /// Its element in the world.
  std::string inWorld;
  /// A document to insert it: SDF or URDF.
  std::string document;
};

/// A message that makes systems do something.
struct KindCommand {
  std::string topic, type, text;
};

/// A kind of entity, sensor or system: the world in which it is tried, in parts, so that its models can be in the file
/// or be inserted later.
struct Kind {
  std::string name;
  /// Name of the world.
  std::string world = "w";
  /// The world's content without its models and levels.
  std::string rest;
  std::vector<KindModel> models;
  /// Names of its lights and actors.
  std::vector<std::string> others;
  /// Content of the plugin for levels: performers of its own.
  std::string performers;
  std::vector<KindCommand> commands;
  /// Whether each of its sensors publishes in each step.
  bool publishesInEachStep = false;

  /// @param withModels Otherwise the models are missing.
  /// @param worldName Its name in place of `world`; the content is the same.
  /// @return The `<world>`, with all that is in it in one level, which is loaded while the model "scout" is near the
  /// origin.
  std::string worldText(bool withModels, const std::string& worldName) const;
};

/// @param content Of the `<world>`.
Kind kindOf(const std::string& name, const std::string& content);

/// @return The kind of world in a system's example, with the commands in its comment.
Kind kindFrom(const std::filesystem::path& file);

}  // namespace pongsim::test
