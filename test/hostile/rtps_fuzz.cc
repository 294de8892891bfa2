// Attacks the participants of a DDS domain on this machine with well-formed but hostile RTPS messages.
//   pongsim_rtps_fuzz --domain N [--seconds S] [--rate PACKETS] [--seed N] [KIND...]
// Kinds: see attacker.hh; without any, all in turn. A rate of 0 means as fast as possible.

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "hostile/attacker.hh"

namespace {

using Clock = std::chrono::steady_clock;
using pongsim::hostile::Attack;

struct Settings {
  int domain = -1;
  double seconds = 10;
  std::uint64_t rate = 0;
  std::uint64_t seed = 1;
  std::vector<Attack> attacks;
};

/// @throws std::invalid_argument unless the text is a number from 0 to 1e15.
double numberFor(const std::string& option, const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !(value >= 0 && value <= 1e15)) {
    throw std::invalid_argument(option + " is '" + text + "', which is not a number from 0");
  }
  return value;
}

/// @throws std::invalid_argument with the fault of the command line.
Settings read(const std::vector<std::string>& arguments) {
  Settings settings;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& name = arguments[i];
    if (!name.starts_with("--")) {
      const auto attack = pongsim::hostile::attackOf(name);
      if (!attack) throw std::invalid_argument("there is no attack '" + name + "'");
      settings.attacks.push_back(*attack);
      continue;
    }
    if (++i == arguments.size()) throw std::invalid_argument(name + " wants a number");
    const double value = numberFor(name, arguments[i]);
    if (name == "--domain") {
      settings.domain = static_cast<int>(std::min(value, 1000.0));
    } else if (name == "--seconds") {
      settings.seconds = value;
    } else if (name == "--rate") {
      settings.rate = static_cast<std::uint64_t>(value);
    } else if (name == "--seed") {
      settings.seed = static_cast<std::uint64_t>(value);
    } else {
      throw std::invalid_argument("there is no option " + name);
    }
  }
  if (settings.domain < 0 || settings.domain > 232)
    throw std::invalid_argument("--domain wants a number from 0 to 232");
  if (settings.attacks.empty()) {
    for (const auto& [name, attack] : pongsim::hostile::attacks()) settings.attacks.push_back(attack);
  }
  return settings;
}

int strike(const Settings& settings) {
  pongsim::hostile::Attacker attacker(settings.domain, settings.seed);
  const std::size_t known = attacker.look(std::chrono::seconds(5));
  if (known == 0) {
    std::fprintf(stderr, "pongsim_rtps_fuzz: error: nobody is in domain %d of this machine\n", settings.domain);
    return 1;
  }
  std::printf("strikes at %zu participants\n", known);
  std::fflush(stdout);
  const auto start = Clock::now();
  const auto end = start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(settings.seconds));
  for (std::uint64_t i = 0; Clock::now() < end; ++i) {
    if (settings.rate > 0) {
      const auto at = std::chrono::duration<double>(static_cast<double>(i) / static_cast<double>(settings.rate));
      std::this_thread::sleep_until(start + std::chrono::duration_cast<Clock::duration>(at));
    }
    // 256 messages of each kind in turn, because some do harm only together
    attacker.strike(settings.attacks[i / 256 % settings.attacks.size()]);
  }
  const double took = std::chrono::duration<double>(Clock::now() - start).count();
  std::printf("%llu packets, %.0f a second\n", static_cast<unsigned long long>(attacker.sent()),
              static_cast<double>(attacker.sent()) / took);
  return 0;
}

}  // namespace

int main(int count, char** texts) {
  try {
    return strike(read({texts + 1, texts + count}));
  } catch (const std::logic_error& error) {
    std::fprintf(stderr,
                 "pongsim_rtps_fuzz: error: %s\nusage: pongsim_rtps_fuzz --domain N [--seconds S] [--rate "
                 "PACKETS] [--seed N] [KIND...]\nkinds:",
                 error.what());
    for (const auto& [name, attack] : pongsim::hostile::attacks())
      std::fprintf(stderr, " %s", std::string(name).c_str());
    std::fputc('\n', stderr);
    return 2;
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "pongsim_rtps_fuzz: error: %s\n", error.what());
    return 1;
  }
}
