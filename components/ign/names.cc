#include "ign/names.hh"

#include <ignition/transport/NodeOptions.hh>
#include <ignition/transport/TopicUtils.hh>

namespace pongsim::ign {

std::optional<std::string> wireName(const std::string& name) {
  std::string full;
  const ignition::transport::NodeOptions options;
  if (!ignition::transport::TopicUtils::FullyQualifiedName(options.Partition(), options.NameSpace(), name, full)) {
    return std::nullopt;
  }
  return full;
}

}  // namespace pongsim::ign
