#include "web/foxglove/typed_channels.hh"

#include <foxglove/scene.pb.h>
#include <foxglove/transforms.pb.h>
#include <google/protobuf/descriptor.h>
#include <ignition/msgs/pose_v.pb.h>

#include <algorithm>
#include <utility>

#include "pongsim/messages/message_schema.hh"
#include "web/foxglove/base64.hh"
#include "web/typed/scene_update.hh"
#include "web/typed/sensor_messages.hh"

namespace pongsim::web::foxglove {

namespace {

constexpr const char* kPrefix = "/foxglove";

bool has(const Lists& lists, const std::string& service) {
  return std::ranges::find(lists.services, service, &OwnService::name) != lists.services.end();
}

/// What a subscription to a scene or to frames holds.
struct SceneSubscription {
  std::shared_ptr<typed::WorldScene> scene;
  std::shared_ptr<void> subscription;
};

}  // namespace

TypedChannels::TypedChannels(std::shared_ptr<Worlds> worlds) : worlds_(std::move(worlds)) {}

std::vector<Channel> TypedChannels::all() {
  std::vector<Channel> channels;
  for (const auto& world : worlds_->all()) {
    if (!has(*world->lists(), typed::WorldScene::serviceOf(world->world()).name)) continue;
    channels.push_back(sceneChannel(world));
    channels.push_back(framesChannel(world));
  }
  for (const auto& place : worlds_->topics()) {
    const auto conversion = typed::conversionOf(place.topic.type);
    if (!conversion || place.topic.publishers == 0) continue;
    Channel made = channel(kPrefix + place.topic.name, conversion->type, place.world.get());
    made.open = [world = place.world, name = place.topic.name, type = place.topic.type, convert = conversion->convert](
                    const std::shared_ptr<Client>& client, std::uint64_t key, const Head& head) {
      return world->subscribe(name, type, {[=](const Payload& message, std::uint64_t timeNs) {
                                client->sendWhenFree(key, [=]() -> Frame {
                                  const auto converted = convert(message.bytes(), timeNs);
                                  return converted ? Frame{head(timeNs), Payload(*converted)} : Frame{};
                                });
                              }});
    };
    channels.push_back(std::move(made));
  }
  return channels;
}

Channel TypedChannels::sceneChannel(const std::shared_ptr<WorldLink>& world) {
  Channel made =
      channel(kPrefix + ("/world/" + world->world()) + "/scene", *::foxglove::SceneUpdate::descriptor(), world.get());
  made.open = [world](const std::shared_ptr<Client>& client, std::uint64_t key, const Head& head) {
    auto open = std::make_shared<SceneSubscription>();
    open->scene = typed::WorldScene::open(world);
    open->subscription = open->scene->watch([=, scene = std::weak_ptr(open->scene)] {
      client->sendWhenFree(key, [=]() -> Frame {
        const auto there = scene.lock();
        const auto state = there ? there->state() : nullptr;
        if (!state) return {};
        const std::uint64_t timeNs = world->timeNs();
        return {head(timeNs), Payload(typed::sceneUpdate(state->scene, timeNs).SerializeAsString())};
      });
    });
    return open;
  };
  return made;
}

Channel TypedChannels::framesChannel(const std::shared_ptr<WorldLink>& world) {
  Channel made =
      channel(kPrefix + ("/world/" + world->world()) + "/tf", *::foxglove::FrameTransforms::descriptor(), world.get());
  made.open = [world](const std::shared_ptr<Client>& client, std::uint64_t key, const Head& head) {
    auto open = std::make_shared<SceneSubscription>();
    open->scene = typed::WorldScene::open(world);
    open->subscription = world->subscribe(
        "/world/" + world->world() + "/pose/info", "ignition.msgs.Pose_V",
        {[=, scene = std::weak_ptr(open->scene)](const Payload& message, std::uint64_t timeNs) {
          client->sendWhenFree(key, [=]() -> Frame {
            const auto there = scene.lock();
            const auto state = there ? there->state() : nullptr;
            ignition::msgs::Pose_V poses;
            const auto bytes = message.bytes();
            if (!state || !poses.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return {};
            return {head(timeNs), Payload(state->frames.transforms(poses, timeNs).SerializeAsString())};
          });
        }});
    return open;
  };
  return made;
}

Channel TypedChannels::channel(std::string topic, const google::protobuf::Descriptor& type, const void* source) {
  return protobufChannel(std::move(topic), type.full_name(), schema(type), source);
}

std::shared_ptr<const std::string> TypedChannels::schema(const google::protobuf::Descriptor& type) {
  std::shared_ptr<const std::string>& schema = schemas_[type.full_name()];
  if (!schema) schema = std::make_shared<const std::string>(base64(messageSchema(type)));
  return schema;
}

}  // namespace pongsim::web::foxglove
