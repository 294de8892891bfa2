// Runs the world for a second and compares what the meter says with the way that the puck must have gone.
#include <ignition/msgs/double.pb.h>
#include <pongsim/simulation.hh>

#include <cmath>
#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  pongsim::Diagnostics diagnostics;
  const auto simulation = pongsim::Simulation::fromFile(argv[1], pongsim::SimulationOptions(), diagnostics);
  for (const pongsim::Diagnostic& diagnostic : diagnostics.all()) {
    std::fprintf(stderr, "%s\n", pongsim::format(diagnostic).c_str());
  }
  if (!simulation || !diagnostics.all().empty()) return 1;

  int count = 0;
  double distance = 0;
  const pongsim::Subscription subscription = simulation->transport().node().subscribe<ignition::msgs::Double>(
      "/model/puck/distance", [&](const ignition::msgs::Double& message) {
        distance = message.data();
        ++count;
      });
  simulation->step(1001);
  std::printf("%d messages, %g m\n", count, distance);
  return count == 51 && std::abs(distance - 2) < 0.01 ? 0 : 1;
}
