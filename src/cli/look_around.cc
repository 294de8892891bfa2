#include "cli/look_around.hh"

#include "cli/console.hh"

namespace pongsim::cli {

namespace {

void warnOfSilence(const Transport& transport) {
  if (!transport.heardAll()) say("warning: some process of this domain does not answer; what it offers is not known");
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
