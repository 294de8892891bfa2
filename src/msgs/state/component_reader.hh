#pragma once

#include <ignition/msgs/double_v.pb.h>
#include <ignition/msgs/serialized_map.pb.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/parse_number.hh"
#include "msgs/state/component.hh"

namespace pongsim::msgs {

/// The components of one entity in a state, by their names in Fortress. Must not outlive the state.
class ComponentReader {
 public:
  explicit ComponentReader(const ignition::msgs::SerializedEntityMap& entity) : entity_(entity) {}

  /// @return The component's bytes; null if the entity does not have it.
  const std::string* find(std::string_view name) const {
    const auto found = entity_.components().find(static_cast<std::int64_t>(componentType(name)));
    return found == entity_.components().end() ? nullptr : &found->second.component();
  }
  bool has(std::string_view name) const { return find(name) != nullptr; }

  std::string text(std::string_view name) const {
    const std::string* const bytes = find(name);
    return bytes == nullptr ? std::string() : *bytes;
  }

  /// @return Nothing if the entity does not have it, or if it is not a number; likewise below.
  std::optional<long long> number(std::string_view name) const {
    const std::string* const bytes = find(name);
    return bytes == nullptr ? std::nullopt : base::parseInteger(*bytes);
  }

  template <class Message>
  std::optional<Message> message(std::string_view name) const {
    const std::string* const bytes = find(name);
    Message message;
    if (bytes == nullptr || !message.ParseFromString(*bytes)) return std::nullopt;
    return message;
  }

  std::vector<double> numbers(std::string_view name) const {
    const auto list = message<ignition::msgs::Double_V>(name);
    return list ? std::vector<double>(list->data().begin(), list->data().end()) : std::vector<double>();
  }

 private:
  const ignition::msgs::SerializedEntityMap& entity_;
};

}  // namespace pongsim::msgs
