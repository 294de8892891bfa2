#include "sim/edits/edit_queue.hh"

#include <utility>

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
    const Request request = std::move(requests_.front());
    requests_.pop_front();
    owner_ = request.owner;
    std::visit([this](const auto& what) { carryOut(what); }, request.what);
  }
  owner_ = nullptr;
}

void EditQueue::carryOut(const Insertion& request) {
  Diagnostics diagnostics;
  std::optional<Model> model = request.insert(edits_, diagnostics);
  if (owner_ == nullptr) return;
  const std::string error = logWarnings(diagnostics, owner_->log());
  if (request.inserted) {
    owner_->answer([&] { request.inserted({model, error}); });
  } else if (!model) {
    owner_->log().warning("a model can't be inserted: " + error);
  }
}

void EditQueue::carryOut(const RemovalOf& request) {
  const std::optional<std::string> refusal = edits_.remove(request.model);
  if (owner_ == nullptr) return;
  if (request.removed) {
    owner_->answer([&] { request.removed(refusal); });
  } else if (refusal) {
    owner_->log().warning("a model can't be removed: " + *refusal);
  }
}

void EditQueue::forget(const SystemSlot& owner) {
  if (owner_ == &owner) owner_ = nullptr;
  std::erase_if(requests_, [&](const Request& request) { return request.owner == &owner; });
}

}  // namespace pongsim::sim
