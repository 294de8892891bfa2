#include "web/rosbridge/publications.hh"

#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "pongsim/node.hh"
#include "web/foxglove/fields.hh"
#include "web/rosbridge/cdr_json.hh"
#include "web/world/message_form.hh"

namespace pongsim::web::rosbridge {

namespace {

constexpr std::size_t kMostPublications = 1000;
constexpr std::size_t kMostIdsOfOne = 100;

}  // namespace

Publications::Publications(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds, RosTopics& topics)
    : client_(std::move(client)), worlds_(std::move(worlds)), topics_(topics) {}

std::string Publications::advertise(const nlohmann::json& request) {
  const auto name = foxglove::textField(request, "topic");
  const auto type = foxglove::textField(request, "type");
  if (!name || !type) return "an advertisement must have a topic and a type";
  if (std::string fault = open(*name, *type); !fault.empty()) return fault;
  std::set<std::string>& ids = publications_.find(*name)->second.ids;
  if (ids.size() < kMostIdsOfOne) ids.insert(foxglove::textField(request, "id").value_or(""));
  return {};
}

std::string Publications::open(const std::string& name, const std::string& type) {
  if (!client_->mayWrite()) return "this client is read-only: '" + name + "' is not published on";
  if (const auto error = topicNameError(name)) return "the topic's name '" + name + "' " + *error;
  const auto before = publications_.find(name);
  if (before != publications_.end()) {
    const std::string& known = before->second.decoder->encoding().type;
    if (known == fullRosType(type)) return {};
    return "'" + name + "' has been advertised with type " + known;
  }
  if (publications_.size() >= kMostPublications) {
    return "a client can publish on at most " + std::to_string(kMostPublications) + " topics";
  }
  // under the name and with the type that the simulation has for it
  const std::vector<RosTopic> there = topics_.find(name);
  const auto all = worlds_->all();
  if (all.empty()) return "there is no world";
  const std::shared_ptr<WorldLink>& world = there.empty() ? all.front() : there.front().place.world;
  auto decoder = topics_.decoder(type, there.empty() ? "" : there.front().place.topic.type);
  if (const auto* fault = std::get_if<std::string>(&decoder)) return *fault;
  Publication publication{std::move(std::get<std::unique_ptr<TopicDecoder>>(decoder)), {}, nullptr, {}};
  std::optional<RosDefinition> definition = readDefinition(publication.decoder->encoding().schema);
  if (!definition) return "the definition of " + type + " can't be read";
  publication.definition = std::move(*definition);
  const std::string ownType = there.empty() ? publication.decoder->messageType() : there.front().place.topic.type;
  publication.publisher = world->advertise(there.empty() ? name : there.front().place.topic.name, ownType);
  if (!publication.publisher) return "the world is too slow";
  publications_.emplace(name, std::move(publication));
  return {};
}

std::string Publications::unadvertise(const nlohmann::json& request) {
  const auto name = foxglove::textField(request, "topic");
  const auto found = name ? publications_.find(*name) : publications_.end();
  if (found == publications_.end()) return "'" + name.value_or("") + "' has not been advertised";
  const auto id = foxglove::textField(request, "id");
  if (id) found->second.ids.erase(*id);
  if (!id || found->second.ids.empty()) publications_.erase(found);
  return {};
}

std::string Publications::publish(const nlohmann::json& request) {
  const auto name = foxglove::textField(request, "topic");
  const auto message = request.find("msg");
  if (!name || message == request.end()) return "a message must have a topic and a msg";
  auto found = publications_.find(*name);
  if (found == publications_.end()) {
    const std::vector<RosTopic> there = topics_.find(*name);
    if (there.empty()) return "'" + *name + "' has not been advertised";
    if (std::string fault = open(*name, there.front().type); !fault.empty()) return fault;
    found = publications_.find(*name);
  }
  const Publication& publication = found->second;
  const Outcome<std::string> payload = writeCdr(publication.definition, *message);
  if (!payload) return "'" + *name + "': " + payload.error;
  try {
    const Message& decoded = publication.decoder->decode(std::as_bytes(std::span(*payload.value)));
    const std::string bytes = writeMessage(decoded, MessageForm::kProtobuf);
    return publication.publisher->publish(Payload(std::string_view(bytes)))
               ? ""
               : "the world is too slow: a message was dropped";
  } catch (const std::runtime_error& error) {
    return "'" + *name + "': " + error.what();
  }
}

}  // namespace pongsim::web::rosbridge
