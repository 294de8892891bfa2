#include "typed_name.hh"

#include <optional>

#include "pongsim/message.hh"
#include "pongsim/node.hh"
#include "pongsim/parameters.hh"

namespace pongsim {

std::string requiredAttribute(const Element& element, std::string_view attribute) {
  const Element::Attribute* found = element.attribute(attribute);
  if (found == nullptr || found->value.empty()) {
    refuse(element, "<" + element.name + "> has no '" + std::string(attribute) + "' attribute");
  }
  return found->value;
}

std::string typeAttribute(const Element& element, std::string_view attribute) {
  const std::string asked = requiredAttribute(element, attribute);
  const std::optional<std::string> found = messageTypeName(asked);
  if (!found) {
    const std::string nearest = nearestMessageType(asked);
    refuse(element, "'" + asked + "' is not a message type", nearest.empty() ? "" : "did you mean '" + nearest + "'?");
  }
  return *found;
}

TypedName typedName(const Element& element, std::string_view nameAttribute, std::string_view typeOfIt) {
  std::string type = typeAttribute(element, typeOfIt);
  std::string topic = cleanTopic(requiredAttribute(element, nameAttribute));
  if (const std::optional<std::string> error = topicNameError(topic)) {
    refuse(element, "'" + topic + "' is not a topic: " + *error);
  }
  if (!topic.starts_with('/')) topic.insert(0, "/");
  return {topic, type};
}

}  // namespace pongsim
