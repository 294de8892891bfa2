#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "web/server/session.hh"
#include "web/server/traffic.hh"

namespace pongsim::web {

/// The channel on which a page gets what the server has sent to all clients, when it asks: {"clients": [{"number",
/// "address", "protocol", "isYou", "topics": {TOPIC: [messages, bytes], ...}}]}, with what belongs to no topic under
/// "".
class TrafficChannel final : public OwnChannel {
 public:
  explicit TrafficChannel(std::shared_ptr<const TrafficBook> book) : book_(std::move(book)) {}

  std::string topic() const override { return "/pongsim/traffic"; }
  std::string schemaName() const override { return "pongsim.Traffic"; }
  std::shared_ptr<void> open(const std::shared_ptr<Client>& client, std::uint64_t key,
                             std::function<std::string(std::uint64_t timeNs)> head) override;
  std::string ask(const std::shared_ptr<void>& opened, const nlohmann::json& wish) override;

 private:
  struct Viewer;

  const std::shared_ptr<const TrafficBook> book_;
};

}  // namespace pongsim::web
