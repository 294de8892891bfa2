#include "cli/service/service_name.hh"

#include <stdexcept>

#include "base/nearest_word.hh"
#include "cli/look_around.hh"
#include "pongsim/node.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"
#include "transport/names/service_name.hh"

namespace pongsim::cli {

std::string serviceOption(std::string_view name) {
  try {
    return transport::absoluteService(name);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

std::string nearestService(std::string_view name, const std::vector<ServiceInfo>& known) {
  std::vector<std::string_view> names;
  for (const ServiceInfo& service : known) names.push_back(service.name);
  return base::didYouMean(name, names);
}

int failWithoutService(Transport& transport, const std::string& service) {
  return fail("no service " + service, nearestService(service, servicesAround(transport)));
}

}  // namespace pongsim::cli
