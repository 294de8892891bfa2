#include "web/foxglove/offers.hh"

#include <utility>

#include "pongsim/messages/message_schema.hh"
#include "web/foxglove/base64.hh"
#include "web/world/waiting.hh"

namespace pongsim::web::foxglove {

namespace {

Offer offerOf(const Worlds::TopicPlace& place, std::shared_ptr<const std::string> schema) {
  Offer offer;
  offer.topic = place.topic.name;
  offer.encoding = "protobuf";
  offer.schemaName = place.topic.type;
  offer.schemaEncoding = "protobuf";
  offer.schema = std::move(schema);
  offer.source = place.world.get();
  offer.open = [world = place.world, name = place.topic.name, type = place.topic.type](
                   const std::shared_ptr<Client>& client, std::uint64_t key, Head head) {
    return world->hear(
        name, type,
        {[client, key, head = std::move(head), most = mostWaiting(type)](const Payload& message, std::uint64_t timeNs) {
          client->sendData(key, most, {head(timeNs), message});
        }});
  };
  return offer;
}

}  // namespace

Offers::Offers(std::shared_ptr<Worlds> worlds) : worlds_(std::move(worlds)) {}

std::vector<Offer> Offers::topics() {
  std::vector<Offer> offers;
  for (const auto& place : worlds_->topics()) offers.push_back(offerOf(place, schema(place.topic.type)));
  return offers;
}

std::shared_ptr<const std::string> Offers::schema(const std::string& type) {
  std::shared_ptr<const std::string>& schema = schemas_[type];
  if (!schema) schema = std::make_shared<const std::string>(base64(messageSchema(type)));
  return schema;
}

}  // namespace pongsim::web::foxglove
