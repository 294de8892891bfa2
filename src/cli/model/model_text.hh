#pragma once

#include <optional>
#include <string>
#include <vector>

#include "msgs/state/state_reader.hh"

namespace pongsim::cli {

/// Which parts of a model to print; all if none is selected.
struct ModelParts {
  bool pose = false;
  /// Empty: all of them; unset: none.
  std::optional<std::string> link, joint, sensor;

  bool areAll() const { return !pose && !link && !joint && !sensor; }
};

/// Formats the models in a world's state.
class ModelTeller {
 public:
  /// @param entities Of one state, sorted by id.
  explicit ModelTeller(std::vector<msgs::EntityState> entities);

  /// @return The names of the top-level models, sorted by id.
  std::vector<std::string> models() const;

  /// @param name "outer::inner", or the name of a nested model if it is unique.
  /// @return Its id; nothing if there is none.
  std::optional<std::uint64_t> find(const std::string& name) const;

  /// @return The names of a model's parts of one kind, for an error about an unknown name.
  std::vector<std::string> namesOf(std::uint64_t model, msgs::EntityState::Kind kind) const;

  /// @return The list of top-level models as printed by `ign model --list`.
  std::string listText() const;
  std::string listJson() const;

  /// @param model Its id.
  /// @return The selected parts as printed by `ign model -m`.
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
