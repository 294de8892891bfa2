#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/report/crash_report.hh"
#include "pongsim/declaration.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"
#include "pongsim/outcome.hh"
#include "pongsim/system.hh"
#include "sim/api/access.hh"
#include "sim/edits/edit_queue.hh"

namespace pongsim::sim {

/// A system of a running world, and everything to which its context refers. All calls of the system's functions go
/// through this class: if it throws or gives an invalid command, it is reported by name and switched off.
class SystemSlot final : public CallGuard {
 public:
  struct Parts {
    /// Model with the `<plugin>`; 0 for the world and for actors.
    ModelId model;
    /// Index of the plugin in the model or world.
    std::size_t number;
    /// Name in messages: "diff-drive of rover".
    std::string name;
    /// Its `<plugin>`, kept because systems may refer to it while they exist.
    Element plugin;
    Node node;
    Random random;
    std::unique_ptr<System> system;
    /// What the system declares; refers to the system.
    Declaration declaration = {};
    /// Actor with the `<plugin>`, if any.
    ActorId actor = {};
    /// Suffix of its name in log messages: " (world b)", or empty.
    std::string where = {};
    /// Whether the program added it.
    bool isAdded = false;
    /// Whether it is from a model from outside or a file of a Fuel server.
    bool isFromOutside = false;
    /// Whether it is a world system of an inserted model: a reset removes it.
    bool endsWithReset = false;
    /// Whether it is not part of saved states.
    bool isWatcher = false;
  };
  /// Called with the reason each time the system is switched off.
  using Failed = std::function<void(const SystemSlot& slot, const std::string& what)>;
  /// Called with each topic that the system advertises.
  using Advertised = std::function<void(const SystemSlot& slot, const std::string& topic)>;

  /// @param edits Carries out the system's requests. It and `access` must outlive this.
  SystemSlot(Parts parts, Access& access, EditQueue& edits, Failed failed, Advertised advertised = {});
  ~SystemSlot() override;

  ModelId model() const { return parts_.model; }
  ActorId actor() const { return parts_.actor; }
  std::size_t number() const { return parts_.number; }
  const std::string& name() const { return parts_.name; }
  bool isAdded() const { return parts_.isAdded; }
  bool isFromOutside() const { return parts_.isFromOutside; }
  bool endsWithReset() const { return parts_.endsWithReset; }
  bool isWatcher() const { return parts_.isWatcher; }
  /// @return Its name in log messages.
  std::string label() const { return parts_.name + parts_.where; }
  const SourcePosition& position() const { return parts_.plugin.position; }
  /// @return The name of a system's random stream. The number distinguishes systems of one kind with the same parent.
  static std::string streamOf(const std::string& name, std::size_t number) {
    return name + "#" + std::to_string(number);
  }
  std::string stream() const { return streamOf(parts_.name, parts_.number); }
  const Declaration& declaration() const { return parts_.declaration; }

  /// Configures the system.
  /// @param world, model, actor Parent of the `<plugin>`; neither model nor actor for the world itself.
  /// @param before The systems before this one.
  /// @return Whether it can be used; otherwise `diagnostics` has the reason.
  bool start(World& world, const std::optional<Model>& model, const std::optional<Actor>& actor,
             std::span<System* const> before, Diagnostics& diagnostics);
  System& system() { return *parts_.system; }
  /// @return Its advertised topics.
  const std::vector<std::string>& topics() const { return topics_; }

  /// Whether its model or actor is set aside: then it is not called, and receives neither messages nor requests.
  void setResting(bool rests) { isResting_ = rests; }
  bool isResting() const { return isResting_; }

  /// Switches it on again, with its random stream as at the start.
  void switchOn(Random random);
  /// Sets its random stream.
  void setRandom(Random random) { parts_.random = random; }

  /// Notes a change of the world that the system, which stands outside, makes or asks for; others come again by
  /// themselves.
  void note(OutsideChange change) const;
  /// @return Where such changes are noted, or null.
  OutsideChanges* notes() const {
    return isOutside_ && access_.outsideChanges.isNoting ? &access_.outsideChanges : nullptr;
  }

  /// Calls a function of the system with the same error handling as its phases.
  void answer(const std::function<void()>& call);
  const Logger& log() const { return log_; }
  /// @return The system's access to topics and services.
  Node& node() { return node_; }

  void preUpdate(const StepInfo& info);
  void update(const StepInfo& info);
  void postUpdate(const StepInfo& info);
  void worldChanged();
  void reset();
  /// Lets the system complete its files, even if it is switched off or set aside.
  Outcome<void> finish();
  /// Saves or restores its state and random stream.
  void transfer(StateArchive& archive);

  using CallGuard::call;
  void call(Moment moment, void (*function)(void* data), void* data) override;
  void advertised(std::string_view topic, std::string_view type) override;
  bool isOfWorld() const override { return !isOutside_; }
  bool isActing() const override {
    return !isOutside_ && access_.systemThread.load(std::memory_order_relaxed) == std::this_thread::get_id();
  }

 private:
  void makeDueChanges();
  template <class Function>
  void run(const char* phase, const Function& function);
  template <class Function>
  void attempt(const char* phase, const Function& function);
  void failed(const char* phase, const std::exception& error);
  void switchOff(const char* phase, const std::string& why);

  Parts parts_;
  /// "the system diff-drive of rover", for crash reports.
  std::string crashName_;
  Logger log_;
  Node node_;
  Access& access_;
  EditQueue& queue_;
  WorldEdits edits_;
  Failed failed_;
  Advertised advertised_;
  std::vector<std::string> topics_;
  // atomic, because publishers' threads read them for subscriptions that are called at once
  std::atomic<bool> isOff_ = false;
  std::atomic<bool> isResting_ = false;
  const bool isOutside_;
  bool isInPreUpdate_ = false;
};

}  // namespace pongsim::sim
