#include "web/foxglove/topic_channels.hh"

#include <google/protobuf/message.h>

#include <utility>

#include "pongsim/message.hh"
#include "pongsim/messages/message_schema.hh"
#include "web/foxglove/base64.hh"
#include "web/foxglove/json_schema.hh"
#include "web/world/queue_depth.hh"

namespace pongsim::web::foxglove {

namespace {

Channel channelOf(const Worlds::TopicPlace& place, std::shared_ptr<const std::string> schema) {
  Channel channel = protobufChannel(place.topic.name, place.topic.type, std::move(schema), place.world.get());
  channel.open = [world = place.world, name = place.topic.name, type = place.topic.type](
                     const std::shared_ptr<Client>& client, std::uint64_t key, Head head) {
    return world->subscribe(
        name, type,
        {[client, key, head = std::move(head), depth = queueDepth(type)](const Payload& message, std::uint64_t timeNs) {
          client->sendData(key, depth, {head(timeNs), message});
        }});
  };
  return channel;
}

}  // namespace

TopicChannels::TopicChannels(std::shared_ptr<Worlds> worlds) : worlds_(std::move(worlds)) {}

std::vector<Channel> TopicChannels::all() {
  std::vector<Channel> channels;
  for (const auto& place : worlds_->topics()) channels.push_back(channelOf(place, schema(place.topic.type)));
  return channels;
}

std::shared_ptr<const std::string> TopicChannels::schema(const std::string& type) {
  std::shared_ptr<const std::string>& schema = schemas_[type];
  if (!schema) schema = std::make_shared<const std::string>(base64(messageSchema(type)));
  return schema;
}

std::shared_ptr<const std::string> TopicChannels::jsonSchema(const std::string& type) {
  std::shared_ptr<const std::string>& schema = jsonSchemas_[type];
  if (!schema) {
    const MessagePointer message = newMessage(type);
    schema = std::make_shared<const std::string>(message ? foxglove::jsonSchema(*message->GetDescriptor()).dump() : "");
  }
  return schema;
}

}  // namespace pongsim::web::foxglove
