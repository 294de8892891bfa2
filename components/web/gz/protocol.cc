#include "web/gz/protocol.hh"

#include <utility>

#include "web/gz/session.hh"

namespace pongsim::web::gz {

namespace {

/// The session of a refused client.
class NoSession final : public Session {
 public:
  void text(std::string_view) override {}
  void binary(std::span<const std::byte>) override {}
};

}  // namespace

GzProtocol::GzProtocol(std::shared_ptr<Worlds> worlds, const AssetSource& assets, GzSettings settings)
    : worlds_(std::move(worlds)), assets_(assets), settings_(std::move(settings)) {}

GzProtocol::~GzProtocol() = default;

std::unique_ptr<Session> GzProtocol::open(const std::string&, const std::shared_ptr<Client>& client) {
  if (settings_.maxConnections >= 0 && sessions_.use_count() > settings_.maxConnections) {
    client->close(1008, "max_connections");
    return std::make_unique<NoSession>();
  }
  return std::make_unique<GzSession>(client, worlds_, assets_, settings_, sessions_);
}

}  // namespace pongsim::web::gz
