#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "pongsim/diagnostic.hh"
#include "pongsim/world_edits.hh"
#include "sim/model_edits.hh"

namespace pongsim::sim {

class SystemSlot;

/// What systems have asked to be inserted and removed, in the order in which they have.
class EditQueue {
 public:
  /// @param edits Must outlive it.
  explicit EditQueue(ModelEdits& edits) : edits_(edits) {}

  using Insert = std::function<std::optional<Model>(ModelEdits&, Diagnostics&)>;
  void insert(SystemSlot& owner, Insert insert, WorldEdits::Inserted inserted);
  void remove(SystemSlot& owner, ModelId model, WorldEdits::Removed removed);

  const ModelEdits& edits() const { return edits_; }

  /// Carries out what has been asked for, but for what is asked for meanwhile.
  void carryOut();

  /// Forgets what that system has asked for.
  void forget(const SystemSlot& owner);
  /// Forgets everything.
  void clear() { requests_.clear(); }

 private:
  struct Insertion {
    Insert insert;
    WorldEdits::Inserted inserted;
  };
  struct RemovalOf {
    ModelId model;
    WorldEdits::Removed removed;
  };
  struct Request {
    std::uint64_t number;
    SystemSlot* owner;
    std::variant<Insertion, RemovalOf> what;
  };

  void carryOut(const Insertion& request);
  void carryOut(const RemovalOf& request);

  ModelEdits& edits_;
  std::deque<Request> requests_;
  std::uint64_t nextNumber_ = 0;
  /// Whose request is carried out now; null where that system has gone with it.
  SystemSlot* owner_ = nullptr;
};

}  // namespace pongsim::sim
