#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pongsim/log.hh"
#include "web/server/client_queue.hh"
#include "web/server/limits.hh"
#include "web/server/session.hh"
#include "web/server/traffic.hh"
#include "web/server/waker.hh"

struct lws;

namespace pongsim::web {

/// A WebSocket connection.
class Connection final : public Client, public Callee, public std::enable_shared_from_this<Connection> {
 public:
  /// @param socket Exists until `ended`; only used on the server's thread.
  Connection(std::shared_ptr<Waker> waker, lws* socket, const ServerLimits& limits, bool mayWrite,
             std::shared_ptr<ClientTraffic> traffic);

  void sendText(std::string text) override;
  void sendBinary(Frame frame) override;
  void sendData(std::uint64_t key, std::size_t most, Frame frame) override;
  void sendWhenFree(std::uint64_t key, std::function<Frame()> make) override;
  void callSoon(std::shared_ptr<Callee> callee) override { waker_->add(std::move(callee)); }
  std::shared_ptr<void> callRegularly(std::weak_ptr<Callee> callee) override {
    return waker_->addRegular(std::move(callee));
  }
  void forget(std::uint64_t key) override;
  void close(std::uint16_t code, std::string reason) override;
  bool mayWrite() const override { return mayWrite_; }
  std::uint64_t dropped() const override { return queue_.dropped(); }
  ClientTraffic& traffic() override { return *traffic_; }

  // The rest is for the server's thread.

  void begin(std::unique_ptr<Session> session) { session_ = std::move(session); }
  /// Asks the library to call `write` when the socket can take data.
  void called() override;
  /// @param buffer Memory for the library, reused.
  /// @return Whether the connection stays open.
  bool write(std::vector<unsigned char>& buffer);
  /// A part of a message has arrived.
  /// @param rest Number of bytes of this fragment still to come.
  void receive(std::string_view part, std::size_t rest, bool isLastPiece, bool isBinary, const Logger& log);
  /// The socket is gone.
  void ended();

 private:
  struct Closing {
    std::uint16_t code = 0;
    std::string reason;
  };

  void add(ClientQueue::Item item);
  void wake();
  bool isClosing() const;
  /// Reads a fragment of a message that is too long to its end, and closes the connection there.
  void dropTooLong(std::size_t rest);
  void deliver(std::string_view message, bool isBinary, const Logger& log);
  bool writePiece(std::vector<unsigned char>& buffer);
  /// @return Always false.
  bool closeNow(const Closing& closing);

  std::shared_ptr<Waker> waker_;
  lws* socket_;
  // a copy, because clients can outlive the server
  const ServerLimits limits_;
  const bool mayWrite_;
  const std::shared_ptr<ClientTraffic> traffic_;
  ClientQueue queue_{limits_};
  std::unique_ptr<Session> session_;
  std::atomic<bool> isAwake_ = false;
  mutable std::mutex mutex_;
  std::optional<Closing> closing_;
  std::atomic<bool> hasEnded_ = false;
  /// The item being sent; `written_` bytes of it are done.
  std::optional<ClientQueue::Item> current_;
  std::size_t written_ = 0;
  std::string message_;
  bool isTooLong_ = false;
};

}  // namespace pongsim::web
