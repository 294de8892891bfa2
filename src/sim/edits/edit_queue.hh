#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "pongsim/diagnostic.hh"
#include "pongsim/world_edits.hh"
#include "sim/edits/model_edits.hh"

namespace pongsim::sim {

class SystemSlot;

/// Requests of systems to insert and remove models, in their order.
class EditQueue {
 public:
  /// @param edits Must outlive this.
  explicit EditQueue(ModelEdits& edits) : edits_(edits) {}

  using Insert = std::function<std::optional<Model>(ModelEdits&, Diagnostics&)>;
  void insert(SystemSlot& owner, Insert insert, WorldEdits::Inserted inserted);
  void remove(SystemSlot& owner, ModelId model, WorldEdits::Removed removed);

  const ModelEdits& edits() const { return edits_; }

  /// Carries out all requests, except those made meanwhile.
  void carryOut();

  /// Discards the requests of a system.
  void forget(const SystemSlot& owner);
  /// Discards all requests.
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
  /// Owner of the current request; null if it was removed by that request.
  SystemSlot* owner_ = nullptr;
};

}  // namespace pongsim::sim
