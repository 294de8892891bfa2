#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/insert_options.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim::description {
struct Model;
}

namespace pongsim::sim {

/// A change of the world by a system that stands outside, in its `preUpdate`, which is no message or request.
struct OutsideChange {
  enum class Kind : std::uint8_t { kSetPose, kSetLinkPose, kSetLinkVelocity, kInsertText, kInsertFile, kRemove };
  /// What is inserted: a text with its name, or the path of a file.
  struct Source {
    bool isFile = false;
    std::string text;
    std::string name;
  };

  Kind kind = Kind::kSetPose;
  /// The random stream of the system, which names it.
  std::string system = {};
  /// Of the model or link.
  std::uint64_t id = 0;
  Pose pose = {};
  /// `AfterMove`
  std::uint8_t after = 0;
  Vector3 linear = Vector3::Zero();
  Vector3 angular = Vector3::Zero();
  Source source = {};
  InsertOptions options = {};

  void transfer(StateArchive& archive);
};

/// Such changes of one world: noted for a recording, or due in a replay.
class OutsideChanges {
 public:
  /// Whether they are noted.
  bool isNoting = false;
  std::vector<OutsideChange> noted;
  /// Number of those that can't be noted.
  std::uint64_t unnoted = 0;
  /// To be made in the next step.
  std::vector<OutsideChange> due;

  /// Keeps what a model was read from, as long as the model exists.
  void keepSource(const std::shared_ptr<const description::Model>& model, OutsideChange::Source source);
  /// @return The source, or null.
  const OutsideChange::Source* sourceOf(const std::shared_ptr<const description::Model>& model) const;

 private:
  std::vector<std::pair<std::weak_ptr<const description::Model>, OutsideChange::Source>> sources_;
};

}  // namespace pongsim::sim
