#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>

namespace pongsim::benchmark {

/// Prints benchmarks as usual, and keeps their medians.
class Medians final : public ::benchmark::ConsoleReporter {
 public:
  /// Runs all registered benchmarks: nine short runs of each in random order, unless the command line says otherwise.
  /// @return Whether the command line was valid.
  bool run(int argc, char** argv);

  /// @return CPU time of a run [the benchmark's unit]; 0 if it was not measured.
  double of(const std::string& name) const;

  void ReportRuns(const std::vector<Run>& runs) override;

 private:
  std::map<std::string, double> medians_;
};

}  // namespace pongsim::benchmark
