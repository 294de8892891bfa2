// Measures a world under each kind of attack: pongsim_siege [SECONDS [KIND...]]. Prints a line for each, and one
// without attack. Exit code 1 if memory, threads, open files or recovery are not within bounds.

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "hostile/attacker.hh"
#include "hostile/siege.hh"

namespace {

using pongsim::hostile::Figures;

// How much the memory of a process may grow [bytes].
constexpr std::uint64_t kGrowth = 100 << 20;

double mega(std::uint64_t bytes) { return static_cast<double>(bytes) / (1 << 20); }

std::ptrdiff_t difference(std::size_t after, std::size_t before) {
  return static_cast<std::ptrdiff_t>(after) - static_cast<std::ptrdiff_t>(before);
}

void print(const std::string& name, const Figures& figures) {
  std::printf("%-20s %7.1f %7.1f %7.1f %8.0f %8.0f %8.2f %8.2f %4td %4td  %s", name.c_str(), mega(figures.memoryBefore),
              mega(figures.memoryMost), mega(figures.memoryAfter), static_cast<double>(figures.steps) / figures.seconds,
              static_cast<double>(figures.messages) / figures.seconds, figures.recovery, figures.clean,
              difference(figures.threadsAfter, figures.threadsBefore),
              difference(figures.descriptorsAfter, figures.descriptorsBefore),
              figures.attacker.empty() ? "\n" : figures.attacker.substr(figures.attacker.find('\n') + 1).c_str());
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** texts) {
  const int seconds = count > 1 ? std::atoi(texts[1]) : 60;
  std::vector<std::string> kinds(texts + std::min(count, 2), texts + count);
  for (const std::string& kind : kinds) {
    if (!pongsim::hostile::attackOf(kind)) {
      std::fprintf(stderr, "pongsim_siege: error: there is no attack '%s'\n", kind.c_str());
      return 2;
    }
  }
  if (seconds <= 0) {
    std::fprintf(stderr, "pongsim_siege: error: usage: pongsim_siege [SECONDS [KIND...]]\n");
    return 2;
  }
  if (kinds.empty()) {
    for (const auto& [name, attack] : pongsim::hostile::attacks()) kinds.emplace_back(name);
  }
  const std::chrono::seconds duration(seconds);
  std::printf("%-20s %7s %7s %7s %8s %8s %8s %8s %4s %4s\n", "attack", "MB", "most", "after", "steps/s", "heard/s",
              "new, s", "lists, s", "thr", "fd");
  bool isFine = true;
  for (const std::string& kind : kinds) {
    pongsim::hostile::Siege siege;
    const Figures rest = siege.rest(std::min<std::chrono::seconds>(duration, std::chrono::seconds(5)));
    print("(rest)", rest);
    const Figures figures = siege.attack({kind}, duration);
    print(kind, figures);
    if (figures.memoryMost > figures.memoryBefore + kGrowth || figures.recovery > 1 || !figures.isListedAsBefore ||
        figures.threadsAfter != figures.threadsBefore || figures.descriptorsAfter != figures.descriptorsBefore) {
      isFine = false;
    }
    if (!siege.endsWell()) {
      std::printf("FAILED: the world does not end well: %s\n", siege.complaints().c_str());
      isFine = false;
    }
  }
  std::puts(isFine ? "fine" : "failed");
  return isFine ? 0 : 1;
}
