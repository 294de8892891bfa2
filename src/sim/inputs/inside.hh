#pragma once

#include "pongsim/simulation.hh"

namespace pongsim::sim {

class Access;

/// What recordings and replays of inputs need of a simulation, beyond its interface.
class Inside {
 public:
  /// One step of that length without handing over messages; zero: nothing moves.
  static void advance(Simulation& simulation, Time dt) { simulation.advance(dt); }
  static Access& access(Simulation& simulation);
  static const Access& access(const Simulation& simulation);
};

}  // namespace pongsim::sim
