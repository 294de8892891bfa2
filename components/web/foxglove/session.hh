#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "web/foxglove/graph.hh"
#include "web/foxglove/log_channel.hh"
#include "web/foxglove/parameters.hh"
#include "web/foxglove/publications.hh"
#include "web/foxglove/service_calls.hh"
#include "web/foxglove/subscriptions.hh"
#include "web/foxglove/topic_channels.hh"
#include "web/foxglove/typed_channels.hh"
#include "web/server/session.hh"
#include "web/world/worlds.hh"

namespace pongsim::web::foxglove {

/// A client that speaks Foxglove's protocol.
class FoxgloveSession final : public Session {
 public:
  /// @param channels, own, typed, log, assets Must outlive it. `own` is null except for our own page, for which `typed`
  /// is null.
  FoxgloveSession(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds, TopicChannels& channels,
                  const OwnChannels* own, TypedChannels* typed, LogChannel& log, const AssetSource& assets);

  void text(std::string_view message) override;
  void binary(std::span<const std::byte> message) override;

 private:
  /// What is reported about the worlds. A separate object, so that data queued for the socket can detect that the
  /// session has ended.
  struct Report {
    Subscriptions subscriptions;
    ServiceCalls calls;
    Graph graph;
    TopicChannels& topics;
    const OwnChannels* own;
    TypedChannels* typed;
    LogChannel& log;

    void follow();
  };

  void sendServerInfo();
  /// Calls a function with each element of a list; it returns what is wrong with the element, or an empty text.
  void each(const nlohmann::json& message, const char* list,
            const std::function<std::string(const nlohmann::json&)>& handle);
  std::string subscribe(const nlohmann::json& subscription);
  void fetchAsset(const nlohmann::json& message);
  void sendError(std::string_view what);

  const std::shared_ptr<Client> client_;
  const std::shared_ptr<Worlds> worlds_;
  const AssetSource& assets_;
  const std::shared_ptr<Report> report_;
  Publications publications_;
  const std::shared_ptr<Parameters> parameters_;
  std::shared_ptr<void> watch_;
  std::shared_ptr<Callee> timeSender_;
  std::shared_ptr<void> regularly_;
};

}  // namespace pongsim::web::foxglove
