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
    std::vector<std::byte> state;
    std::set<ModelId> models;
    std::uint64_t hash = 0;
    std::uint64_t later = 0;
  };

  void change(Operation operation);
  void insert();
  void copy();
  void remove(bool isFirstOnly);
  void move();
  void reset();
  void save();
  void restore();
  void moveScout(double x);
  void listen();
  void command();
  void changeLight();

  void step();
  void settle();
  void noteModels();
  void noteTopics();
  std::set<ModelId> modelIds();
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
  /// The topics on which systems have published, with their types.
  std::map<std::string, std::string> topics_;
  /// Those that are, or were, subscribed to.
  std::set<std::string> listened_;
  /// Messages since the last operation.
  std::map<std::string, int> heard_;
  std::vector<Subscription> subscriptions_;
  std::map<std::string, Publisher> publishers_;
};

}  // namespace pongsim::test
