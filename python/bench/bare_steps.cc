#include <chrono>
#include <cstdlib>
#include <iostream>

#include "pongsim/simulation.hh"

/// Prints what a step of a world takes [us], called one by one: bare_steps WORLD STEPS.
int main(int argc, char** argv) {
  if (argc != 3) return 2;
  pongsim::Diagnostics diagnostics;
  const auto simulation = pongsim::Simulation::fromFile(argv[1], {}, diagnostics);
  const long steps = std::atol(argv[2]);
  if (simulation == nullptr || steps <= 0) return 1;
  simulation->offerEdits();
  simulation->step(100);
  const auto begin = std::chrono::steady_clock::now();
  for (long i = 0; i < steps; ++i) simulation->step();
  const std::chrono::duration<double, std::micro> taken = std::chrono::steady_clock::now() - begin;
  std::cout << taken.count() / static_cast<double>(steps) << "\n";
}
