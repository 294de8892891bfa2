#include "web/system/plain_protocol.hh"

#include <cstddef>
#include <span>
#include <string_view>

#include "web/rosbridge/session.hh"

namespace pongsim::web {

namespace {

class PlainSession final : public Session {
 public:
  PlainSession(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds, rosbridge::RosTopics& topics,
               std::unique_ptr<Session> gz)
      : client_(std::move(client)), worlds_(std::move(worlds)), topics_(topics), session_(std::move(gz)) {}

  void text(std::string_view message) override {
    if (std::exchange(isFirst_, false) && rosbridge::isRosbridge(message)) {
      session_ = std::make_unique<rosbridge::RosbridgeSession>(client_, worlds_, topics_);
    }
    session_->text(message);
  }

  void binary(std::span<const std::byte> message) override {
    isFirst_ = false;
    session_->binary(message);
  }

 private:
  const std::shared_ptr<Client> client_;
  const std::shared_ptr<Worlds> worlds_;
  rosbridge::RosTopics& topics_;
  std::unique_ptr<Session> session_;
  bool isFirst_ = true;
};

}  // namespace

std::unique_ptr<Session> PlainProtocol::open(const std::string& name, const std::shared_ptr<Client>& client) {
  return std::make_unique<PlainSession>(client, worlds_, rosTopics_, gz_.open(name, client));
}

}  // namespace pongsim::web
