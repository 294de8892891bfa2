#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor_database.h>
#include <google/protobuf/message.h>
#include <google/protobuf/stubs/logging.h>

#include <algorithm>

#include "base/nearest_word.hh"
#include "msgs/types/type_source.hh"
#include "pongsim/log.hh"
#include "pongsim/message.hh"

namespace pongsim {

namespace {

namespace protobuf = google::protobuf;

constexpr std::string_view kPackage = "ignition.msgs.";
constexpr std::string_view kPrefixes[] = {kPackage,   ".ignition.msgs.", "ign_msgs.",
                                          "gz.msgs.", ".gz.msgs.",       "gz_msgs."};

/// Protobuf's own log messages about bad payloads and texts are for developers: every caller here reports errors
/// itself.
void tellDevelopers(protobuf::LogLevel, const char*, int, const std::string& message) {
  static const Logger log("protobuf");
  log.debug(message);
}

/// Set while the library is loaded: protobuf requires that there are no other threads yet.
[[maybe_unused]] protobuf::LogHandler* const previousLogHandler = protobuf::SetLogHandler(tellDevelopers);

std::string_view withoutPackage(std::string_view name) {
  for (std::string_view prefix : kPrefixes) {
    if (name.starts_with(prefix)) return name.substr(prefix.size());
  }
  return name;
}

const protobuf::Descriptor* findType(std::string_view name) {
  const protobuf::Descriptor* type =
      msgs::typeSource().pool.FindMessageTypeByName(std::string(kPackage) + std::string(withoutPackage(name)));
  // Map entries are messages only inside protobuf.
  return type == nullptr || type->map_key() != nullptr ? nullptr : type;
}

}  // namespace

std::optional<std::string> messageTypeName(std::string_view name) {
  const protobuf::Descriptor* type = findType(name);
  if (type == nullptr) return std::nullopt;
  return type->full_name();
}

std::string nearestMessageType(std::string_view name) {
  const std::vector<std::string> types = messageTypes();
  std::vector<std::string_view> known;
  known.reserve(types.size());
  for (const std::string& type : types) known.push_back(withoutPackage(type));
  const std::string_view nearest = base::nearestWord(withoutPackage(name), known);
  return nearest.empty() ? std::string() : std::string(kPackage) + std::string(nearest);
}

std::vector<std::string> messageTypes() {
  std::vector<std::string> all;
  msgs::typeSource().database.FindAllMessageNames(&all);
  std::erase_if(all, [](const std::string& name) { return !name.starts_with(kPackage) || findType(name) == nullptr; });
  std::sort(all.begin(), all.end());
  return all;
}

void MessageDeleter::operator()(Message* message) const { delete message; }

MessagePointer newMessage(std::string_view name) {
  const protobuf::Descriptor* type = findType(name);
  if (type == nullptr) return nullptr;
  return MessagePointer(msgs::typeSource().factory.GetPrototype(type)->New());
}

}  // namespace pongsim
