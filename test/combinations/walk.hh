#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "combinations/kind.hh"
#include "combinations/operation.hh"
#include "pongsim/simulation.hh"

namespace pongsim::test {

/// Makes operations with a world, some steps after each, and checks what each promises.
class Walk {
 public:
  /// @param beside Stepped along with it.
  Walk(const Kind& kind, Simulation& simulation, std::vector<Simulation*> beside = {});

  void make(Operation operation);

  /// Checks that after a reset every sensor publishes in its time.
  void expectReadings();

 private:
  /// What was saved, and what followed.
  struct Saved {
    std::vector<std::byte> state = {};
    std::vector<ModelId> ids = {};
    /// In the order of `ids`, and what each is a copy of.
    std::vector<std::string> names = {}, origins = {};
    std::uint64_t hash = 0;
    std::uint64_t later = 0;
  };

  void change(Operation operation);
  void insert();
  void copy();
  void insertWithin();
  void remove(bool isFirstOnly);
  void move();
  void reset();
  void save();
  void restore();
  void moveScout(double x);
  void listen();
  void command();
  void changeLight();
  void attach();

  /// @return Whether a joint of `attach` holds.
  bool isAttached() const;
  void step();
  void settle();
  /// Adds which models there are now.
  void describeModels(Saved& saved);
  void noteModels();
  void noteTopics();
  void expectStatesAfter(Operation operation);
  void expectHandles();
  /// @return The topics of the sensors that are there.
  std::set<std::string> sensorTopics();
  void publish(const std::string& topic, const std::string& type, const std::string& text);

  const Kind& kind_;
  Simulation& simulation_;
  std::vector<Simulation*> beside_;
  /// Whether nothing from outside reaches it.
  bool isAlone_;
  std::uint64_t start_ = 0;
  std::uint64_t afterStart_ = 0;
  bool isRestored_ = false;
  Saved saved_;
  /// All top-level models that there are or that are set aside.
  std::map<ModelId, Model> models_;
  std::map<ModelId, std::string> names_;
  /// Which of the kind's models an inserted one is.
  std::map<ModelId, std::string> origins_;
  /// The topics on which systems have published, with their types.
  std::map<std::string, std::string> topics_;
  /// Those that are, or were, subscribed to.
  std::set<std::string> listened_;
  /// Messages since the last operation.
  std::map<std::string, int> heard_;
  std::vector<Subscription> subscriptions_;
  std::map<std::string, Publisher> publishers_;
  /// Made by `attach`.
  std::vector<Joint> joints_;
};

}  // namespace pongsim::test
