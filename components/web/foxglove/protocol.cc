#include "web/foxglove/protocol.hh"

#include <utility>

#include "web/foxglove/session.hh"

namespace pongsim::web::foxglove {

namespace {

constexpr const char* kOurPage = "pongsim.web.v1";

}  // namespace

FoxgloveProtocol::FoxgloveProtocol(std::shared_ptr<Worlds> worlds, const OwnChannels& own, RecentLog& log,
                                   const AssetSource& assets)
    : worlds_(std::move(worlds)), own_(own), assets_(assets), topicChannels_(worlds_), typed_(worlds_), log_(log) {}

FoxgloveProtocol::~FoxgloveProtocol() = default;

std::vector<std::string> FoxgloveProtocol::names() const {
  return {"foxglove.sdk.v1", "foxglove.websocket.v1", kOurPage};
}

std::unique_ptr<Session> FoxgloveProtocol::open(const std::string& name, const std::shared_ptr<Client>& client) {
  if (name == kOurPage)
    return std::make_unique<FoxgloveSession>(client, worlds_, topicChannels_, &own_, nullptr, log_, assets_);
  return std::make_unique<FoxgloveSession>(client, worlds_, topicChannels_, nullptr, &typed_, log_, assets_);
}

}  // namespace pongsim::web::foxglove
