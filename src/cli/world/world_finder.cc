#include "cli/world/world_finder.hh"

#include <algorithm>
#include <string_view>
#include <vector>

#include "base/nearest_word.hh"
#include "cli/look_around.hh"
#include "cli/stop_signal.hh"
#include "msgs/control/control_messages.hh"
#include "pongsim/message.hh"
#include "pongsim/node.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

constexpr std::string_view kWorldPrefix = "/world/", kControlSuffix = "/control";
/// Time from one look to the next.
constexpr std::chrono::milliseconds kBetweenLooks{20};
// Worlds that run answer within it.
constexpr std::chrono::milliseconds kShortestLook{500};

/// @return The names of the worlds that can be controlled, as used in topics.
std::vector<std::string> worldsOf(const std::vector<ServiceInfo>& services) {
  std::vector<std::string> worlds;
  for (const ServiceInfo& service : services) {
    std::string_view name = service.name;
    if (name.size() <= kWorldPrefix.size() + kControlSuffix.size()) continue;
    if (!name.starts_with(kWorldPrefix) || !name.ends_with(kControlSuffix)) continue;
    name.remove_prefix(kWorldPrefix.size());
    name.remove_suffix(kControlSuffix.size());
    if (name.find('/') == std::string_view::npos) worlds.emplace_back(name);
  }
  return worlds;
}

/// @return The first world of the process that runs all of them; nothing if there are several processes.
std::optional<std::string> firstOf(Transport& transport, const std::vector<std::string>& worlds,
                                   std::chrono::nanoseconds timeout) {
  const MessagePointer request = newMessage("ignition.msgs.Empty");
  const MessagePointer reply = newMessage("ignition.msgs.StringMsg_V");
  if (!transport.node().call("/gazebo/worlds", *request, *reply, timeout)) return std::nullopt;
  std::vector<std::string> names = msgs::strings(*reply);
  for (std::string& name : names) name = cleanTopic(name);
  const auto isIn = [&names](const std::string& world) { return std::ranges::count(names, world) > 0; };
  if (names.empty() || !std::ranges::all_of(worlds, isIn)) return std::nullopt;
  return names.front();
}

}  // namespace

std::optional<std::string> findWorld(Transport& transport, const StopSignal& signal, const std::string& wanted,
                                     std::chrono::nanoseconds timeout, WorldChoice choice) {
  const std::string name = cleanTopic(wanted);
  const auto deadline = std::chrono::steady_clock::now() + timeout;
  std::vector<std::string> worlds;
  while (true) {
    worlds = worldsOf(
        transport.discoverServices(std::clamp<std::chrono::nanoseconds>(timeout, kShortestLook, kDiscoveryTime)));
    const bool found = name.empty() ? !worlds.empty() : std::ranges::count(worlds, name) > 0;
    if (found || signal.stopped() || std::chrono::steady_clock::now() >= deadline) break;
    transport.dispatchFor(kBetweenLooks);
  }
  if (worlds.empty()) {
    fail("no world is running", "start one with pongsim run WORLD");
    return std::nullopt;
  }
  if (!name.empty() && std::ranges::count(worlds, name) == 0) {
    fail("no world '" + wanted + "' is running",
         base::didYouMean(name, std::vector<std::string_view>(worlds.begin(), worlds.end())));
    return std::nullopt;
  }
  if (name.empty() && worlds.size() > 1) {
    std::string names;
    for (const std::string& world : worlds) names += (names.empty() ? "" : ", ") + world;
    if (const auto first = choice == WorldChoice::kFirst ? firstOf(transport, worlds, timeout) : std::nullopt) {
      say("several worlds are running: " + names + "; using " + *first + " (choose with -w WORLD)");
      return first;
    }
    fail("several worlds are running: " + names, "choose with -w WORLD");
    return std::nullopt;
  }
  return name.empty() ? worlds.front() : name;
}

}  // namespace pongsim::cli
