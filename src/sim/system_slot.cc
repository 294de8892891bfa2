#include "sim/system_slot.hh"

#include <exception>
#include <utility>

namespace pongsim::sim {

namespace {

/// @return What a `<plugin>` must stand in, where it does not.
const char* missingPlace(Declaration::Place place, bool isInModel, bool isInActor) {
  if (place == Declaration::Place::kModel && !isInModel) return "a <model>";
  if (place == Declaration::Place::kWorld && (isInModel || isInActor)) return "a <world>";
  if (place == Declaration::Place::kActor && !isInActor) return "an <actor>";
  return nullptr;
}

}  // namespace

SystemSlot::SystemSlot(Parts parts, Access& access, EditQueue& edits, Failed failed, Advertised advertised)
    : parts_(std::move(parts)),
      crashName_("the system " + label()),
      log_(label()),
      node_(parts_.node.guardedBy(*this)),
      access_(access),
      queue_(edits),
      edits_(edits, *this),
      failed_(std::move(failed)),
      advertised_(std::move(advertised)) {}

SystemSlot::~SystemSlot() {
  const base::RunningPart running(crashName_.c_str(), "in its destructor");
  parts_.system.reset();
  queue_.forget(*this);
}

bool SystemSlot::start(World& world, const std::optional<Model>& model, const std::optional<Actor>& actor,
                       std::span<System* const> before, Diagnostics& diagnostics) {
  const Element& plugin = parts_.plugin;
  const std::string left = parts_.name + " is left out: ";
  const base::RunningPart running(crashName_.c_str(), "in configure");
  try {
    parts_.system->declare(declaration_);
    if (const char* place = missingPlace(declaration_.place(), model.has_value(), actor.has_value())) {
      diagnostics.warning(plugin.position, left + "it belongs in " + place);
      return false;
    }
    if (!declaration_.read(plugin, parts_.name, diagnostics)) return false;
    parts_.system->configure({plugin, world, model, node_, log_, parts_.random, diagnostics, before, edits_, actor});
    return true;
  } catch (const Error& error) {
    const Diagnostic& found = error.diagnostic();
    diagnostics.warning(found.position, left + found.message, found.hint);
  } catch (const std::exception& error) {
    diagnostics.warning(plugin.position, left + error.what());
  }
  return false;
}

bool SystemSlot::begin(const char* phase) {
  if (isOff_ || isResting_) return false;
  phase_ = phase;
  running_.emplace(crashName_.c_str(), phase);
  access_.inSystem = true;
  return true;
}

void SystemSlot::leave() {
  access_.inSystem = false;
  running_.reset();
  if (!access_.badCommand) return;
  switchOff(*std::exchange(access_.badCommand, std::nullopt));
}

void SystemSlot::failed(const std::exception& error) {
  if (dynamic_cast<const Gone*>(&error) == nullptr) return switchOff(error.what());
  // it has used a handle to what is gone, for which it can't be blamed
  isOff_ = true;
  log_.warning(std::string("stops until the next reset: ") + error.what());
}

void SystemSlot::switchOff(const std::string& why) {
  if (isOff_) return;
  isOff_ = true;
  failed_(*this, std::string("failed ") + phase_ + ": " + why);
}

void SystemSlot::advertised(std::string_view topic, std::string_view) {
  topics_.emplace_back(topic);
  if (advertised_) advertised_(*this, topics_.back());
}

void SystemSlot::switchOn(Random random) {
  isOff_ = false;
  setRandom(random);
}

template <class Call>
void SystemSlot::run(const char* phase, Call call) {
  if (!begin(phase)) return;
  try {
    call(*parts_.system);
  } catch (const std::exception& error) {
    failed(error);
  } catch (...) {
    switchOff("it threw something other than a std::exception");
  }
  leave();
}

void SystemSlot::answer(const std::function<void()>& call) {
  run("in the answer to an edit", [&](System&) { call(); });
}

void SystemSlot::preUpdate(const StepInfo& info) {
  run("in preUpdate", [&](System& system) { system.preUpdate(info); });
}

void SystemSlot::update(const StepInfo& info) {
  run("in update", [&](System& system) { system.update(info); });
}

void SystemSlot::postUpdate(const StepInfo& info) {
  run("in postUpdate", [&](System& system) { system.postUpdate(info); });
}

void SystemSlot::worldChanged() {
  run("in worldChanged", [](System& system) { system.worldChanged(); });
}

void SystemSlot::transfer(StateArchive& archive) {
  parts_.random.transfer(archive);
  archive(isOff_);
  parts_.system->transfer(archive);
}

void SystemSlot::reset() {
  run("in reset", [](System& system) { system.reset(); });
}

}  // namespace pongsim::sim
