#pragma once

#include <gtest/gtest.h>

#include <concepts>
#include <string>
#include <string_view>
#include <vector>

#include "sdf/loader.hh"

namespace pongsim::sdf::test {

/// A loaded file and the messages about it.
struct Loaded {
  Root root;
  /// Errors and warnings, then those about content that is not simulated, as `format` writes them, but each on one
  /// line: the hint after " | ", the positions of includes in brackets.
  std::vector<std::string> messages;

  const description::World& world() const { return root.worlds.at(0); }
  const description::Model& model() const { return world().models.at(0); }
};

/// @param read Loads it, adding messages to the `Diagnostics` that it is given.
template <class Read>
Loaded load(Read read)
  requires std::invocable<Read, Diagnostics&>
{
  Loaded loaded;
  Diagnostics diagnostics;
  loaded.root = read(diagnostics);
  for (const Diagnostic& diagnostic : loaded.root.unsimulated.all()) diagnostics.add(diagnostic);
  for (Diagnostic diagnostic : diagnostics.all()) {
    std::string ending = diagnostic.hint.empty() ? "" : " | " + diagnostic.hint;
    for (const SourcePosition& place : diagnostic.includedFrom) {
      ending += " (from " + *place.file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ")";
    }
    diagnostic.hint.clear();
    diagnostic.includedFrom.clear();
    loaded.messages.push_back(format(diagnostic) + ending);
  }
  return loaded;
}

/// Loads a text under the name "t.sdf". Files that it includes are not found.
inline Loaded load(std::string_view text) {
  return load([text](Diagnostics& diagnostics) { return loadText(text, "t.sdf", diagnostics, assets::finderIn({})); });
}

/// Loads the content of a world, which begins in line 2, column 1.
inline Loaded loadWorld(std::string_view content, std::string_view version = "1.9") {
  return load("<sdf version='" + std::string(version) + "'><world name='w'>\n" + std::string(content) +
              "\n</world></sdf>");
}

/// Loads the content of a model 'm', which begins in line 3, column 1.
inline Loaded loadModel(std::string_view content, std::string_view version = "1.9") {
  return loadWorld("<model name='m'>\n" + std::string(content) + "\n</model>", version);
}

/// Loads the content of a link 'l' of a model 'm', which begins in line 4, column 1.
inline Loaded loadLink(std::string_view content) {
  return loadModel("<link name='l'>\n" + std::string(content) + "\n</link>");
}

using Messages = std::vector<std::string>;

inline void expectPose(const Pose& pose, const Vector3& position, const Quaternion& rotation = Quaternion::Identity()) {
  EXPECT_LT((pose.position - position).norm(), 1e-12) << pose.position.transpose();
  EXPECT_LT(pose.rotation.angularDistance(rotation), 1e-7) << pose.rotation.coeffs().transpose();
}

}  // namespace pongsim::sdf::test
