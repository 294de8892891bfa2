#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/crash_report.hh"
#include "pongsim/declaration.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/system.hh"
#include "sim/access.hh"
#include "sim/edit_queue.hh"

namespace pongsim::sim {

/// One system of a running world, with all that its context refers to. Whatever calls into the system goes through
/// here: a system that throws, or gives a command that makes no sense, is named and switched off.
class SystemSlot final : public CallGuard {
 public:
  struct Parts {
    /// Where the `<plugin>` stands; 0 for the world and for actors.
    ModelId model;
    /// Which plugin of the model or of the world.
    std::size_t number;
    /// "diff-drive of rover".
    std::string name;
    /// Where its `<plugin>` is.
    SourcePosition position;
    Node node;
    Random random;
    std::unique_ptr<System> system;
    /// Where the `<plugin>` stands in an actor.
    ActorId actor = {};
    /// Behind the name where it speaks: " (world b)", or empty.
    std::string where = {};
    /// The program itself has added it.
    bool isAdded = false;
  };
  /// Told why the system has been switched off, each time.
  using Failed = std::function<void(const SystemSlot& slot, const std::string& what)>;

  /// @param edits Carries out what the system asks for; must outlive it, as `access`.
  SystemSlot(Parts parts, Access& access, EditQueue& edits, Failed failed);
  ~SystemSlot() override;

  ModelId model() const { return parts_.model; }
  ActorId actor() const { return parts_.actor; }
  std::size_t number() const { return parts_.number; }
  const std::string& name() const { return parts_.name; }
  bool isAdded() const { return parts_.isAdded; }
  /// @return The name by which it speaks.
  std::string label() const { return parts_.name + parts_.where; }
  const SourcePosition& position() const { return parts_.position; }
  /// @return The name of a system's random stream. The number keeps apart two of a kind in one place.
  static std::string streamOf(const std::string& name, std::size_t number) {
    return name + "#" + std::to_string(number);
  }
  std::string stream() const { return streamOf(parts_.name, parts_.number); }
  const Declaration& declaration() const { return declaration_; }

  /// Declares and configures the system.
  /// @param world, model, actor Where the `<plugin>` stands; neither model nor actor for the world itself.
  /// @param before The systems before this one.
  /// @return Whether it can be used; else `diagnostics` says why not.
  bool start(const Element& plugin, World& world, const std::optional<Model>& model, const std::optional<Actor>& actor,
             std::span<System* const> before, Diagnostics& diagnostics);
  System& system() { return *parts_.system; }
  /// @return What it has advertised.
  const std::vector<std::string>& topics() const { return topics_; }

  /// Whether its model is set aside: it is not called, and gets neither messages nor requests.
  void setResting(bool rests) { isResting_ = rests; }
  bool isResting() const { return isResting_; }

  /// Calls it again from now on, with random numbers as at the start.
  void switchOn(Random random);
  /// Its random numbers begin there, where it draws the next one.
  void setRandom(Random random) { parts_.random = random; }

  /// Calls a function of the system's as its phases are called.
  void answer(const std::function<void()>& call);
  const Logger& log() const { return log_; }

  void preUpdate(const StepInfo& info);
  void update(const StepInfo& info);
  void postUpdate(const StepInfo& info);
  void worldChanged();
  void reset();
  /// What it remembers, with its random stream.
  void transfer(StateArchive& archive);

  bool enter() override { return begin("in a message or request"); }
  void leave() override;
  void failed(const std::exception& error) override;
  void advertised(std::string_view topic, std::string_view type) override;

 private:
  template <class Call>
  void run(const char* phase, Call call);
  void switchOff(const std::string& why);
  bool begin(const char* phase);

  Parts parts_;
  /// "the system diff-drive of rover", for a crash.
  std::string crashName_;
  Logger log_;
  Node node_;
  Access& access_;
  EditQueue& queue_;
  WorldEdits edits_;
  Failed failed_;
  Declaration declaration_;
  std::vector<std::string> topics_;
  bool isOff_ = false;
  bool isResting_ = false;
  const char* phase_ = "";
  std::optional<base::RunningPart> running_;
};

}  // namespace pongsim::sim
