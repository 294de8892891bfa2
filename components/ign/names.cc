#include "ign/names.hh"

#include <ignition/transport/NodeOptions.hh>
#include <ignition/transport/TopicUtils.hh>

#include <utility>

namespace pongsim::ign {

namespace {

constexpr std::string_view kIgnPackage = "ignition.msgs.", kGzPackage = "gz.msgs.";

std::string renamed(std::string type, std::string_view from, std::string_view to) {
  if (type.starts_with(from)) type.replace(0, from.size(), to);
  return type;
}

}  // namespace

std::string wireType(std::string type, Generation generation) {
  return generation == Generation::kGz ? renamed(std::move(type), kIgnPackage, kGzPackage) : type;
}

std::string ownType(std::string type) { return renamed(std::move(type), kGzPackage, kIgnPackage); }

std::optional<std::string> wireName(const std::string& name) {
  std::string full;
  const ignition::transport::NodeOptions options;
  if (!ignition::transport::TopicUtils::FullyQualifiedName(options.Partition(), options.NameSpace(), name, full)) {
    return std::nullopt;
  }
  return full;
}

}  // namespace pongsim::ign
