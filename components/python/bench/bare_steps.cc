#include <cstdlib>
#include <ctime>
#include <iostream>

#include "pongsim/simulation.hh"

/// Prints what processor time a step of a world takes [us], called one by one: bare_steps WORLD STEPS.
int main(int argc, char** argv) {
  if (argc != 3) return 2;
  pongsim::Diagnostics diagnostics;
  const auto simulation = pongsim::Simulation::fromFile(argv[1], {}, diagnostics);
  const long steps = std::atol(argv[2]);
  if (simulation == nullptr || steps <= 0) return 1;
  simulation->offerEdits();
  simulation->step(100);
  const std::clock_t begin = std::clock();
  for (long i = 0; i < steps; ++i) simulation->step();
  const auto taken = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;  // [s]
  std::cout << taken * 1e6 / static_cast<double>(steps) << "\n";
}
