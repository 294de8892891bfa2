#pragma once

#include <optional>
#include <string>
#include <vector>

#include "msgs/state/state_reader.hh"

namespace pongsim::cli {

/// What of a model is told; where nothing is asked for, all.
struct ModelParts {
  bool pose = false;
  /// Empty: all of them; unset: none.
  std::optional<std::string> link, joint, sensor;

  bool areAll() const { return !pose && !link && !joint && !sensor; }
};

/// A world as its state tells of it.
class ModelTeller {
 public:
  /// @param entities Of one state, in the order of their ids.
  explicit ModelTeller(std::vector<msgs::EntityState> entities);

  /// @return The names of the models at the top level, in the order of their ids.
  std::vector<std::string> models() const;

  /// @param name "outer::inner", or the name of one that is nested somewhere, if it is the only one.
  /// @return Its id; nothing where there is none.
  std::optional<std::uint64_t> find(const std::string& name) const;

  /// @return The names of what a model has of that kind, for one who has asked for another.
  std::vector<std::string> namesOf(std::uint64_t model, msgs::EntityState::Kind kind) const;

  /// @return The models at the top level as `ign model --list` prints them.
  std::string listText() const;
  std::string listJson() const;

  /// @param model Its id.
  /// @return What is asked for as `ign model -m` prints it.
  std::string text(std::uint64_t model, const ModelParts& parts) const;
  /// @return The same as one JSON object.
  std::string json(std::uint64_t model, const ModelParts& parts) const;

 private:
  class Printer;
  const msgs::EntityState& entity(std::uint64_t id) const;
  std::vector<const msgs::EntityState*> childrenOf(std::uint64_t parent, msgs::EntityState::Kind kind) const;
  std::string scopedName(const msgs::EntityState& model) const;

  std::vector<msgs::EntityState> entities_;
};

}  // namespace pongsim::cli
