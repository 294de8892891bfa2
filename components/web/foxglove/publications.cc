#include "web/foxglove/publications.hh"

#include <utility>
#include <variant>

#include "pongsim/node.hh"
#include "web/foxglove/fields.hh"

namespace pongsim::web::foxglove {

namespace {

constexpr std::size_t kMostChannels = 1000;
// Limit of errors with a suggested type, because finding one takes milliseconds.
constexpr std::size_t kMostHints = 10;

std::string unknown(std::uint32_t channel) { return "the client has no channel " + std::to_string(channel); }

}  // namespace

Publications::Publications(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds)
    : client_(std::move(client)), worlds_(std::move(worlds)) {}

std::string Publications::open(const nlohmann::json& channel) {
  if (std::string what = fault(channel); !what.empty()) return what;
  const std::string topic = *textField(channel, "topic");
  const std::string type = *messageTypeName(*textField(channel, "schemaName"));
  const std::shared_ptr<WorldLink> world = worldFor(topic);
  std::shared_ptr<RemotePublisher> publisher = world ? world->advertise(topic, type) : nullptr;
  if (!publisher) return "no world subscribes to '" + topic + "' now";
  const MessageForm form = *textField(channel, "encoding") == "json" ? MessageForm::kJson : MessageForm::kProtobuf;
  publications_.emplace(*idField(channel, "id"), Publication{type, form, std::move(publisher)});
  return {};
}

/// @return What is wrong with it, or an empty text.
std::string Publications::fault(const nlohmann::json& channel) {
  const auto id = idField(channel, "id");
  const auto topic = textField(channel, "topic");
  const auto encoding = textField(channel, "encoding");
  const auto type = textField(channel, "schemaName");
  if (!id || !topic || !encoding || !type) return "a channel must have an id, a topic, an encoding and a schemaName";
  if (!client_->mayWrite()) return "this client is read-only: '" + *topic + "' is not published on";
  if (publications_.contains(*id)) return "channel " + std::to_string(*id) + " already exists";
  if (publications_.size() >= kMostChannels) {
    return "a client can publish on at most " + std::to_string(kMostChannels) + " channels";
  }
  if (*encoding != "json" && *encoding != "protobuf") {
    return "messages on '" + *topic + "' can be protobuf or json, not '" + *encoding + "'";
  }
  if (const auto error = topicNameError(*topic)) return "the topic's name '" + *topic + "' " + *error;
  if (!messageTypeName(*type)) {
    const std::string nearest = ++unknownTypes_ <= kMostHints ? nearestMessageType(*type) : std::string();
    return "there is no message type '" + *type + "'" + (nearest.empty() ? "" : "; did you mean '" + nearest + "'?");
  }
  return {};
}

/// @return The world that has the topic, else the first one, or null.
std::shared_ptr<WorldLink> Publications::worldFor(const std::string& topic) const {
  if (const auto place = worlds_->findTopic(topic)) return place->world;
  const auto all = worlds_->all();
  return all.empty() ? nullptr : all.front();
}

std::string Publications::close(std::uint32_t channel) {
  return publications_.erase(channel) == 0 ? unknown(channel) : std::string();
}

std::string Publications::publish(std::uint32_t channel, std::span<const std::byte> message) {
  const auto found = publications_.find(channel);
  if (found == publications_.end()) return unknown(channel);
  const auto read = readMessage(found->second.type, found->second.form, message);
  if (const auto* what = std::get_if<std::string>(&read)) return *what;
  const std::string bytes = writeMessage(*std::get<MessagePointer>(read), MessageForm::kProtobuf);
  return found->second.publisher->publish(Payload(bytes)) ? "" : "the world is too slow: a message was dropped";
}

}  // namespace pongsim::web::foxglove
