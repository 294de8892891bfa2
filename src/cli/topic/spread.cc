#include "cli/topic/spread.hh"

#include <algorithm>
#include <cmath>

namespace pongsim::cli {

Spread spreadOf(const std::vector<double>& values) {
  Spread spread{0, values.front(), values.front(), 0};
  for (const double value : values) {
    spread.mean += value / static_cast<double>(values.size());
    spread.least = std::min(spread.least, value);
    spread.most = std::max(spread.most, value);
  }
  double squares = 0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
  spread.deviation = std::sqrt(squares / static_cast<double>(values.size()));
  return spread;
}

}  // namespace pongsim::cli
