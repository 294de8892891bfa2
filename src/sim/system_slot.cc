#include "sim/system_slot.hh"

#include <exception>
#include <utility>

#include "sim/edits/editor.hh"

namespace pongsim::sim {

namespace {

/// @return The element in which the `<plugin>` has to be, if it is not; else null.
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
      advertised_(std::move(advertised)),
      isOutside_(parts_.declaration.isOutside()) {}

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
    const Declaration& declaration = parts_.declaration;
    if (const char* place = missingPlace(declaration.place(), model.has_value(), actor.has_value())) {
      diagnostics.warning(plugin.position, left + "it belongs in " + place);
      return false;
    }
    if (declaration.hasFiles() && parts_.isFromOutside) {
      diagnostics.warning(plugin.position, left + "it uses files, which what is inserted or downloaded may not name");
      return false;
    }
    if (!declaration.read(plugin, parts_.name, diagnostics)) return false;
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

/// Calls a function of the system on the simulation's thread, possibly within a call of another system or of the same
/// one. The first invalid command of the outer call is saved meanwhile.
template <class Function>
void SystemSlot::run(const char* phase, const Function& function) {
  if (isOff_ || isResting_) return;
  constexpr auto kRelaxed = std::memory_order_relaxed;
  const bool isNested = access_.systemThread.load(kRelaxed) != std::thread::id();
  std::optional<std::string> outerCommand;
  if (isNested) outerCommand.swap(access_.badCommand);
  access_.systemThread.store(std::this_thread::get_id(), kRelaxed);
  if (isOutside_) {
    // what it makes others do at once comes from outside, too
    SystemSlot* const outer = std::exchange(access_.outsider, this);
    attempt(phase, function);
    access_.outsider = outer;
  } else {
    attempt(phase, function);
  }
  if (access_.badCommand) switchOff(phase, *std::exchange(access_.badCommand, std::nullopt));
  if (isNested) {
    access_.badCommand.swap(outerCommand);
  } else {
    access_.systemThread.store(std::thread::id(), kRelaxed);
  }
}

template <class Function>
void SystemSlot::attempt(const char* phase, const Function& function) {
  const base::RunningPart running(crashName_.c_str(), phase);
  try {
    function();
  } catch (const std::exception& error) {
    failed(phase, error);
  } catch (...) {
    switchOff(phase, "it threw something other than a std::exception");
  }
}

void SystemSlot::call(Moment moment, void (*function)(void* data), void* data) {
  constexpr const char* kPhase = "in a message or request";
  const auto call = [&] { function(data); };
  if (moment == Moment::kDispatch || access_.systemThread == std::this_thread::get_id()) {
    run(kPhase, call);
  } else if (!isOff_ && !isResting_) {
    // possibly on another thread, while the simulation's thread runs a system
    attempt(kPhase, call);
  }
}

void SystemSlot::failed(const char* phase, const std::exception& error) {
  if (dynamic_cast<const Gone*>(&error) == nullptr) return switchOff(phase, error.what());
  // the system has used a handle to a removed entity: no failure of the run, even if it is strict
  isOff_ = true;
  log_.warning(std::string("stops until the next reset: ") + error.what());
}

void SystemSlot::switchOff(const char* phase, const std::string& why) {
  if (isOff_.exchange(true)) return;
  failed_(*this, std::string("failed ") + phase + ": " + why);
}

void SystemSlot::advertised(std::string_view topic, std::string_view) {
  topics_.emplace_back(topic);
  if (advertised_) advertised_(*this, topics_.back());
}

void SystemSlot::switchOn(Random random) {
  isOff_ = false;
  setRandom(random);
}

void SystemSlot::answer(const std::function<void()>& call) { run("in the answer to an edit", call); }

void SystemSlot::preUpdate(const StepInfo& info) {
  isInPreUpdate_ = isOutside_;
  if (isOutside_) makeDueChanges();
  run("in preUpdate", [&] { system().preUpdate(info); });
  isInPreUpdate_ = false;
}

void SystemSlot::note(OutsideChange change) const {
  OutsideChanges* const changes = notes();
  if (changes == nullptr) return;
  if (!isInPreUpdate_) {
    ++changes->unnoted;
    return;
  }
  change.system = stream();
  changes->noted.push_back(std::move(change));
}

/// Makes the changes that the system made here in the run that is replayed.
void SystemSlot::makeDueChanges() {
  using enum OutsideChange::Kind;
  std::erase_if(access_.outsideChanges.due, [this](const OutsideChange& change) {
    if (change.system != stream()) return false;
    const auto after = static_cast<AfterMove>(change.after);
    const world::Slot model = access_.entities.slot(ModelId{change.id});
    const world::Slot link = access_.entities.slot(LinkId{change.id});
    if (change.kind == kInsertText) edits_.insertText(change.source.text, change.source.name, change.options);
    if (change.kind == kInsertFile) edits_.insertFile(change.source.text, change.options);
    if (change.kind == kRemove) queue_.remove(*this, ModelId{change.id}, {});
    if (change.kind == kSetPose && model != world::kNoSlot) Editor(access_).setPose(model, change.pose, after);
    if (change.kind == kSetLinkPose && link != world::kNoSlot) Editor(access_).setLinkPose(link, change.pose, after);
    if (change.kind == kSetLinkVelocity && link != world::kNoSlot) {
      Editor(access_).setLinkVelocity(link, change.linear, change.angular);
    }
    return true;
  });
}

void SystemSlot::update(const StepInfo& info) {
  run("in update", [&] { system().update(info); });
}

void SystemSlot::postUpdate(const StepInfo& info) {
  run("in postUpdate", [&] { system().postUpdate(info); });
}

void SystemSlot::worldChanged() {
  run("in worldChanged", [this] { system().worldChanged(); });
}

void SystemSlot::transfer(StateArchive& archive) {
  parts_.random.transfer(archive);
  bool isOff = isOff_;
  archive(isOff);
  isOff_ = isOff;
  parts_.system->transfer(archive);
}

Outcome<void> SystemSlot::finish() {
  const base::RunningPart running(crashName_.c_str(), "in finish");
  try {
    system().finish();
  } catch (const std::exception& error) {
    return {error.what()};
  } catch (...) {
    return {"it threw something other than a std::exception"};
  }
  return {};
}

void SystemSlot::reset() {
  run("in reset", [this] { system().reset(); });
}

}  // namespace pongsim::sim
