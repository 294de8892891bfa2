#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "web/gz/frame.hh"
#include "web/gz/settings.hh"
#include "web/gz/subscriptions.hh"
#include "web/server/session.hh"
#include "web/world/worlds.hh"

namespace pongsim::web::gz {

/// A client that speaks the protocol of ign-launch's WebSocket server. Everything sent to it is binary.
class GzSession final : public Session {
 public:
  /// @param assets, settings Must outlive it.
  /// @param counted Held for its lifetime.
  GzSession(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds, const AssetSource& assets,
            const GzSettings& settings, std::shared_ptr<void> counted);
  ~GzSession() override;
  GzSession(const GzSession&) = delete;
  GzSession& operator=(const GzSession&) = delete;

  void text(std::string_view message) override;
  void binary(std::span<const std::byte> message) override;

 private:
  /// An operation, run once the client is authenticated.
  using Operation = void (GzSession::*)(const Call& call);
  static const std::map<std::string_view, Operation>& operations();

  void auth(const Call& call);
  void protos(const Call& call);
  void topics(const Call& call);
  void topicsTypes(const Call& call);
  void worlds(const Call& call);
  void scene(const Call& call);
  void particleEmitters(const Call& call);
  void subscribe(const Call& call);
  void image(const Call& call);
  void unsubscribe(const Call& call);
  void throttle(const Call& call);
  void advertise(const Call& call);
  void publish(const Call& call);
  void request(const Call& call);
  void asset(const Call& call);

  /// Requests for lists of topics that wait until all worlds have listed theirs.
  struct Deferred;
  void sendTopics();
  void sendTopicsTypes();

  RemotePublisher* publisherFor(const Call& call, const std::string& type);
  void requestFromWorld(const Call& call, const char* service, const char* type);
  void error(std::string_view about, std::string_view text);

  const std::shared_ptr<Client> client_;
  const std::shared_ptr<Worlds> worlds_;
  const AssetSource& assets_;
  const GzSettings& settings_;
  const std::shared_ptr<void> counted_;
  bool isAuthorized_;
  /// The client's publishers, by topic and type.
  std::map<std::pair<std::string, std::string>, std::unique_ptr<RemotePublisher>> publishers_;
  const std::shared_ptr<Subscriptions> subscriptions_;
  const std::shared_ptr<Deferred> deferred_;
  std::shared_ptr<void> watch_;
};

}  // namespace pongsim::web::gz
