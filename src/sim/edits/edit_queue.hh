#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

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

  void insertFirst();
  /// @param end Number of the first request that has to wait.
  void removeFirst(std::uint64_t end);
  /// Moves the first request to those being carried out.
  void takeFirst();

  ModelEdits& edits_;
  std::deque<Request> requests_;
  std::uint64_t nextNumber_ = 0;
  /// Requests being carried out. The owner of one is null if it was removed by them.
  std::vector<Request> current_;
};

}  // namespace pongsim::sim
