#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "web/server/session.hh"

namespace pongsim::web {

/// Sends back what it receives, and performs some actions requested by text.
class EchoSession final : public Session {
 public:
  explicit EchoSession(std::shared_ptr<Client> client) : client_(std::move(client)) {}
  void text(std::string_view message) override {
    if (message == "fail") throw std::runtime_error("it was told to");
    if (message == "close") return client_->close(1008, "you asked");
    if (message == "may I?") return client_->sendText(client_->mayWrite() ? "yes" : "no");
    client_->sendText(std::string(message));
  }
  void binary(std::span<const std::byte> message) override {
    Payload payload(message.size());
    std::ranges::copy(message, payload.bytes().begin());
    client_->sendBinary({.head = "echo:", .body = payload});
  }

 private:
  std::shared_ptr<Client> client_;
};

/// The protocol "echo", also of clients that name none. It greets each client.
class EchoProtocol : public Protocol {
 public:
  std::vector<std::string> names() const override { return {"echo", ""}; }
  std::unique_ptr<Session> open(const std::string& name, const std::shared_ptr<Client>& client) override {
    client->sendText("hello " + name);
    return std::make_unique<EchoSession>(client);
  }
};

}  // namespace pongsim::web
