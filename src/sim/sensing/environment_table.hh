#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/outcome.hh"
#include "pongsim/sensing/environment.hh"
#include "pongsim/types.hh"

namespace pongsim::sim {

/// The lines of a table with an environment, as they are in its file.
struct EnvironmentTable {
  struct Row {
    double time = 0;
    Vector3 place;
    /// Its place in the file.
    std::size_t index = 0;
  };

  /// Reads comma-separated values: cells may be in double quotes; empty lines are skipped.
  Outcome<void> read(std::string_view csv, const EnvironmentSettings& settings);

  /// Names of the columns but those for time and place.
  std::vector<std::string> quantities;
  std::vector<Row> rows;
  /// By row and quantity.
  std::vector<double> values;
};

}  // namespace pongsim::sim
