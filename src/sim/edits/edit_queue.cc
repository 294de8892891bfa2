#include "sim/edits/edit_queue.hh"

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "sim/diagnostic_log.hh"
#include "sim/system_slot.hh"

namespace pongsim::sim {

void EditQueue::insert(SystemSlot& owner, Insert insert, WorldEdits::Inserted inserted) {
  requests_.push_back({nextNumber_++, &owner, Insertion{std::move(insert), std::move(inserted)}});
}

void EditQueue::remove(SystemSlot& owner, ModelId model, WorldEdits::Removed removed) {
  requests_.push_back({nextNumber_++, &owner, RemovalOf{model, std::move(removed)}});
}

void EditQueue::carryOut() {
  const std::uint64_t end = nextNumber_;
  while (!requests_.empty() && requests_.front().number < end) {
    if (std::holds_alternative<Insertion>(requests_.front().what)) {
      insertFirst();
    } else {
      removeFirst(end);
    }
    current_.clear();
  }
}

void EditQueue::takeFirst() {
  current_.push_back(std::move(requests_.front()));
  requests_.pop_front();
}

void EditQueue::insertFirst() {
  takeFirst();
  const Request& request = current_.front();
  const auto& [insert, inserted] = std::get<Insertion>(request.what);
  Diagnostics diagnostics;
  std::optional<Model> model = insert(edits_, diagnostics);
  if (request.owner == nullptr) return;
  const std::string error = logWarnings(diagnostics, request.owner->log());
  if (inserted) {
    request.owner->answer([&] { inserted({model, error}); });
  } else if (!model) {
    request.owner->log().warning("a model can't be inserted: " + error);
  }
}

// Carries out all removals up to the next insertion together: each removal moves all entities behind the removed ones.
// Stops before a request of a system whose model is being removed; `forget` discards it.
void EditQueue::removeFirst(std::uint64_t end) {
  std::vector<Outcome<void>> outcomes;
  std::vector<ModelId> models;
  std::set<ModelId> gone;
  while (!requests_.empty() && requests_.front().number < end) {
    const auto* removal = std::get_if<RemovalOf>(&requests_.front().what);
    if (removal == nullptr || gone.contains(edits_.topLevel(requests_.front().owner->model()))) break;
    const bool isAgain = gone.contains(removal->model);
    outcomes.push_back(isAgain ? Outcome<void>{std::string(ModelEdits::kNoLongerThere)}
                               : edits_.mayRemove(removal->model));
    if (outcomes.back()) gone.insert(removal->model);
    takeFirst();
  }
  edits_.remove(std::vector<ModelId>(gone.begin(), gone.end()));
  for (std::size_t i = 0; i < current_.size(); ++i) {
    // the callback may remove systems, among them owners of later requests
    const Request& request = current_[i];
    if (request.owner == nullptr) continue;
    const auto& removed = std::get<RemovalOf>(request.what).removed;
    if (removed) {
      request.owner->answer([&] { removed(outcomes[i]); });
    } else if (!outcomes[i]) {
      request.owner->log().warning("a model can't be removed: " + outcomes[i].error);
    }
  }
}

void EditQueue::forget(const SystemSlot& owner) {
  for (Request& request : current_) {
    if (request.owner == &owner) request.owner = nullptr;
  }
  std::erase_if(requests_, [&](const Request& request) { return request.owner == &owner; });
}

}  // namespace pongsim::sim
