#include "cli/look_around.hh"

#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

void warnOfSilence(const Transport& transport) {
  if (!transport.heardAll())
    say("warning: a process in this DDS domain does not answer; its topics and services may be missing");
}

}  // namespace

std::vector<TopicInfo> topicsAround(Transport& transport) {
  std::vector<TopicInfo> topics = transport.discover(kDiscoveryTime);
  warnOfSilence(transport);
  return topics;
}

std::vector<ServiceInfo> servicesAround(Transport& transport) {
  std::vector<ServiceInfo> services = transport.discoverServices(kDiscoveryTime);
  warnOfSilence(transport);
  return services;
}

}  // namespace pongsim::cli
