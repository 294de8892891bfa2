#include "sim/system_set.hh"

#include <algorithm>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>

#include "base/prefetch.hh"
#include "sim/plugin_elements.hh"

namespace pongsim::sim {

namespace {

/// @return " (world.sdf:41:9)"; empty if it is not from a file.
std::string inBrackets(const SourcePosition& position) {
  if (!position.file || position.line <= 0) return {};
  return " (" + *position.file + ":" + std::to_string(position.line) + ":" + std::to_string(position.column) + ")";
}

}  // namespace

SystemSet::SystemSet(Access& access, ModelEdits& edits, Transport& transport, std::uint64_t seed, bool strict,
                     const WorldPlace& place)
    : access_(access),
      transport_(transport),
      seed_(seed),
      strict_(strict),
      place_(place),
      world_(access),
      defaultSceneBroadcaster_(defaultSceneBroadcaster()),
      queue_(edits) {}

SystemSet::~SystemSet() = default;

std::vector<SensorReadings> SystemSet::readings(std::string_view sensorType) const {
  std::vector<SensorReadings> found;
  for (const SystemSlot& slot : slots_) {
    std::ranges::copy_if(slot.declaration().readings(), std::back_inserter(found),
                         [&](const SensorReadings& each) { return each.sensorType == sensorType; });
  }
  return found;
}

bool SystemSet::start(SystemSlot::Parts parts, const std::optional<Model>& model, const std::optional<Actor>& actor,
                      Diagnostics& diagnostics) {
  SystemSlot& slot = slots_.emplace_back(
      std::move(parts), access_, queue_,
      [this](const SystemSlot& each, const std::string& what) { noteFailure(each, what); },
      [this](const SystemSlot& each, const std::string& topic) { noteTopic(each, topic); });
  if (!slot.start(world_, model, actor, systems_, diagnostics)) {
    forgetTopics(slot);
    slots_.pop_back();
    return false;
  }
  systems_.push_back(&slot.system());
  warnOfSharedTopics(slot, diagnostics);
  return true;
}

void SystemSet::noteTopic(const SystemSlot& slot, const std::string& topic) { publishers_[topic].push_back(&slot); }

void SystemSet::forgetTopics(const SystemSlot& slot) {
  for (const std::string& topic : slot.topics()) {
    const auto found = publishers_.find(topic);
    if (found == publishers_.end()) continue;
    std::erase(found->second, &slot);
    if (found->second.empty()) publishers_.erase(found);
  }
}

void SystemSet::warnOfSharedTopics(const SystemSlot& slot, Diagnostics& diagnostics) const {
  if (slot.declaration().topicsAreShared()) return;
  std::vector<const SystemSlot*> named;
  for (const std::string& topic : slot.topics()) {
    for (const SystemSlot* other : publishers_.at(topic)) {
      // only for systems of one kind: other subscribers and publishers of a topic may know of each other
      if (other == &slot || other->declaration().text() != slot.declaration().text()) continue;
      if (std::ranges::find(named, other) != named.end()) continue;
      named.push_back(other);
      diagnostics.warning(slot.position(),
                          slot.name() + " publishes on '" + topic + "', and so does " + other->name() + " in line " +
                              std::to_string(other->position().line),
                          "subscribers get the messages of both");
    }
  }
}

/// @return A system's random stream. In the first world of a file it is the same as in a file with that world only; in
/// the others it also depends on the world's name.
Random SystemSet::stream(const std::string& name) const {
  return {seed_, place_.number == 0 ? name : std::string(world_.name()) + ": " + name};
}

std::string SystemSet::where() const { return place_.isAlone ? "" : " (world " + std::string(world_.name()) + ")"; }

void SystemSet::noteFailure(const SystemSlot& slot, const std::string& what) {
  if (!strict_) {
    Logger(slot.label()).error(what + "; it is switched off" + inBrackets(slot.position()));
  } else if (!failure_) {
    failure_ = slot.label() + " " + what;
  }
}

void SystemSet::check() const {
  if (failure_) throw std::runtime_error(*failure_);
}

template <class Predicate>
void SystemSet::end(Predicate predicate) {
  slots_.remove_if([&](const SystemSlot& slot) {
    const bool ends = predicate(slot);
    if (ends) forgetTopics(slot);
    return ends;
  });
}

void SystemSet::unload(const std::vector<ModelId>& models) {
  end([&](const SystemSlot& slot) { return std::ranges::binary_search(models, slot.model()); });
  collect();
  // does not allocate: memory was reserved when the file was loaded
  std::ranges::copy_if(models, std::back_inserter(unloaded_), [this](ModelId model) { return model <= lastOfFile_; });
}

void SystemSet::updateWhoRests() {
  const auto isAside = [this](auto id) { return access_.entities.isSetAside(id.value); };
  for (SystemSlot& slot : slots_) slot.setResting(isAside(slot.model()) || isAside(slot.actor()));
  collect();
}

void SystemSet::collect() {
  systems_.clear();
  awake_.clear();
  for (SystemSlot& slot : slots_) {
    systems_.push_back(&slot.system());
    if (!slot.isResting()) awake_.push_back(&slot);
  }
}

void SystemSet::announceChanges() {
  if (!access_.hasChanged) return;
  access_.hasChanged = false;
  for (SystemSlot& slot : slots_) slot.worldChanged();
}

void SystemSet::reset(Diagnostics& diagnostics, std::optional<std::uint64_t> seed) {
  seed_ = seed.value_or(seed_);
  forgetPast();
  end([&](const SystemSlot& slot) {
    return slot.endsWithReset() || (slot.model() && access_.entities.slot(slot.model()) == world::kNoSlot);
  });
  collect();
  for (const ModelId model : std::exchange(unloaded_, {})) {
    const world::Slot slot = access_.entities.slot(model);
    if (slot != world::kNoSlot) loadOwnPlugins(slot, {paths_}, diagnostics);
  }
  putInOrder();
  updateWhoRests();
  for (SystemSlot& slot : slots_) slot.switchOn(stream(slot.stream()));
  announceChanges();
  for (SystemSlot& slot : slots_) {
    // set again, because systems may have drawn numbers in `worldChanged`
    slot.setRandom(stream(slot.stream()));
    slot.reset();
  }
}

void SystemSet::forgetPast() {
  queue_.clear();
  failure_.reset();
}

void SystemSet::jump() {
  for (SystemSlot& slot : slots_) slot.reset();
}

Outcome<void> SystemSet::finish() {
  Outcome<void> outcome;
  for (SystemSlot& slot : slots_) {
    const Outcome<void> done = slot.finish();
    if (!done) outcome.error += (outcome.error.empty() ? "" : "; ") + slot.label() + ": " + done.error;
  }
  return outcome;
}

std::vector<std::string> SystemSet::save() {
  std::vector<std::string> saved;
  for (SystemSlot& slot : slots_) {
    if (slot.isWatcher()) continue;
    StateArchive archive;
    slot.transfer(archive);
    const std::vector<std::byte> bytes = archive.take();
    saved.emplace_back(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }
  return saved;
}

void SystemSet::restore(const std::vector<std::string>& saved, bool awakeOnly) {
  const auto isSaved = [](const SystemSlot& slot) { return !slot.isWatcher(); };
  if (std::cmp_not_equal(saved.size(), std::ranges::count_if(slots_, isSaved)))
    throw std::runtime_error("it is of other systems");
  auto next = saved.begin();
  for (SystemSlot& slot : slots_) {
    if (!isSaved(slot)) continue;
    StateArchive archive(std::as_bytes(std::span(next->data(), next->size())));
    ++next;
    if (awakeOnly && slot.isResting()) continue;
    try {
      slot.transfer(archive);
    } catch (const std::exception& error) {
      throw std::runtime_error("system " + slot.name() + ": " + error.what());
    }
    if (!archive.rest().empty())
      throw std::runtime_error("system " + slot.name() + ": it has more than the system reads");
  }
}

void SystemSet::addTo(base::Hash& hash) const {
  for (const SystemSlot& slot : slots_) {
    if (!slot.isWatcher()) hash.add(slot.stream());
  }
}

/// Sorts the systems as they were loaded at the start: those of the world, of each model, of each actor, added ones,
/// watchers.
void SystemSet::putInOrder() {
  const auto place = [this](const SystemSlot& slot) {
    return std::tuple(slot.isWatcher(), slot.isAdded(), slot.actor(),
                      slot.model() ? access_.entities.slot(slot.model()) + 1 : 0, slot.number());
  };
  slots_.sort([&](const SystemSlot& a, const SystemSlot& b) { return place(a) < place(b); });
}

/// Prefetches the systems that are called soon: a thousand systems do not fit into the nearest caches.
void SystemSet::lookAhead(std::size_t system) const {
  constexpr std::size_t kFar = 8, kNear = 4, kBytes = 512;
  if (system + kFar < awake_.size()) base::prefetch(*awake_[system + kFar]);
  if (system + kNear < awake_.size()) base::prefetch(awake_[system + kNear]->system(), kBytes);
}

void SystemSet::preUpdate(const StepInfo& info) {
  // a system may have failed in a message or request since the last step
  check();
  queue_.carryOut();
  announceChanges();
  for (std::size_t i = 0; i < awake_.size(); ++i) {
    lookAhead(i);
    awake_[i]->preUpdate(info);
  }
  check();
}

void SystemSet::update(const StepInfo& info) {
  for (std::size_t i = 0; i < awake_.size(); ++i) {
    lookAhead(i);
    awake_[i]->update(info);
  }
  check();
}

void SystemSet::postUpdate(const StepInfo& info) {
  for (std::size_t i = 0; i < awake_.size(); ++i) {
    lookAhead(i);
    awake_[i]->postUpdate(info);
  }
  queue_.carryOut();
  check();
}

}  // namespace pongsim::sim
