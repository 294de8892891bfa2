#include "sim/running/real_time_factor.hh"

#include <algorithm>

namespace pongsim::sim {

void RealTimeFactor::sample(WallTime wall, Time simulated) {
  // the world was reset: simulated time went back
  if (count_ > 0 && simulated < newest().simulated) restart();
  if (count_ > 0 && wall - newest().wall < kSpacing) return;
  samples_[next_] = {wall, simulated};
  next_ = (next_ + 1) % kCapacity;
  count_ = std::min(count_ + 1, kCapacity);
}

double RealTimeFactor::value() const {
  if (count_ < 2) return 0;
  const double wall = std::chrono::duration<double>(newest().wall - oldest().wall).count();
  return wall > 0 ? toSeconds(newest().simulated - oldest().simulated) / wall : 0;
}

}  // namespace pongsim::sim
