#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "support/web/recorded_client.hh"
#include "support/web/stepped_world.hh"
#include "web/foxglove/protocol.hh"

namespace pongsim::web::foxglove {

/// A channel for tests that only our own page is offered.
class RecordedOwnChannel final : public OwnChannel {
 public:
  std::string topic() const override { return "/world/w/frame"; }
  std::string schemaName() const override { return "pongsim.Frame"; }
  std::shared_ptr<void> open(const std::shared_ptr<Client>& client, std::uint64_t key,
                             std::function<std::string(std::uint64_t timeNs)> head) override {
    client->sendWhenFree(key, [head] { return Frame{head(1), Payload("frame")}; });
    return std::make_shared<int>(0);
  }
  std::string ask(const std::shared_ptr<void>& opened, const nlohmann::json& wish) override {
    return opened ? wish.value("wrong", "") : "it is not open";
  }
};

class RecordedOwnChannels final : public OwnChannels {
 public:
  std::vector<std::shared_ptr<OwnChannel>> all() const override { return {channel_}; }
  std::uint64_t version() const override { return 1; }

 private:
  std::shared_ptr<OwnChannel> channel_ = std::make_shared<RecordedOwnChannel>();
};

/// A client that speaks the protocol with a world.
class SessionTest : public testing::Test {
 protected:
  using json = nlohmann::json;

  void open(const std::string& name = "foxglove.websocket.v1") { session_ = protocol_.open(name, client_); }
  void say(const json& message) { session_->text(message.dump()); }
  void say(const std::string& bytes) { session_->binary(std::as_bytes(std::span(bytes))); }

  /// Steps until a message with this operation has arrived, and returns it.
  json await(const std::string& operation) {
    json found;
    world_.stepUntil([&] {
      client_->free();
      for (const std::string& text : client_->takeTexts()) received_.push_back(json::parse(text));
      for (auto each = received_.begin(); each != received_.end(); ++each) {
        if ((*each)["op"] != operation) continue;
        found = *each;
        received_.erase(each);
        return true;
      }
      return false;
    });
    return found;
  }
  /// Steps until an entry with this name is listed, and returns it.
  json awaitListed(const std::string& operation, const std::string& list, const std::string& key,
                   const std::string& name) {
    for (int i = 0; i < 20; ++i) {
      const json message = await(operation);
      if (message.is_null()) break;
      for (const json& each : message[list]) {
        if (each[key] == name) return each;
      }
    }
    return {};
  }
  json channel(const std::string& topic) { return awaitListed("advertise", "channels", "topic", topic); }
  json service(const std::string& name) { return awaitListed("advertiseServices", "services", "name", name); }
  /// Steps until a binary message of this kind has arrived, and returns what follows the kind.
  std::string awaitBinary(char kind) {
    std::string found;
    world_.stepUntil([&] {
      client_->free();
      for (const std::string& bytes : client_->takeBinaries()) {
        if (found.empty() && bytes[0] == kind) found = bytes.substr(1);
      }
      return !found.empty();
    });
    return found;
  }
  std::string status() { return await("status").value("message", ""); }
  static std::string number(std::uint32_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
    return bytes;
  }
  static std::string callOf(std::uint32_t service, const std::string& encoding, const std::string& request) {
    return "\x02" + number(service) + number(77) + number(static_cast<std::uint32_t>(encoding.size())) + encoding +
           request;
  }

  std::shared_ptr<Worlds> worlds_ = std::make_shared<Worlds>();
  SteppedWorld world_{worlds_};
  std::shared_ptr<RecordedClient> client_ = std::make_shared<RecordedClient>();
  RecordedOwnChannels own_;
  RecordedAssets assets_;
  RecentLog log_;
  FoxgloveProtocol protocol_{worlds_, own_, log_, assets_};
  std::unique_ptr<Session> session_;
  std::vector<json> received_;
};

}  // namespace pongsim::web::foxglove
