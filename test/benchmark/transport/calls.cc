#include "calls.hh"

#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <thread>

namespace pongsim::benchmark {

double quantile(std::vector<Microseconds> all, double part) {
  std::ranges::sort(all);
  return all[std::min(all.size() - 1, static_cast<std::size_t>(part * static_cast<double>(all.size())))].count();
}

std::string summary(const std::vector<Microseconds>& all) {
  if (all.empty()) return "none";
  char text[120];
  std::snprintf(text, sizeof text, "median %7.1f us, 99.9 %% %8.1f us, worst %8.1f us", quantile(all, 0.5),
                quantile(all, 0.999), quantile(all, 1));
  return text;
}

void Calls::measure(const std::function<void()>& call) {
  rusage before{}, after{};
  getrusage(RUSAGE_THREAD, &before);
  const auto begin = Clock::now();
  call();
  took.push_back(Clock::now() - begin);
  getrusage(RUSAGE_THREAD, &after);
  waits += after.ru_nvcsw > before.ru_nvcsw ? 1 : 0;
  pushes += after.ru_nivcsw > before.ru_nivcsw ? 1 : 0;
}

Calls publishAt(double rate, int count, const std::function<void()>& publish, const std::function<void()>& between) {
  Calls calls;
  const auto start = Clock::now();
  const auto sleepUntil = [&](double period) {
    std::this_thread::sleep_until(start +
                                  std::chrono::duration_cast<Clock::duration>(period / rate * std::chrono::seconds(1)));
  };
  for (int i = 0; i < count; ++i) {
    sleepUntil(i);
    calls.measure(publish);
    if (!between) continue;
    sleepUntil(i + 0.5);
    between();
  }
  return calls;
}

}  // namespace pongsim::benchmark
