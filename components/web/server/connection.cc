#include "web/server/connection.hh"

#include <libwebsockets.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <span>
#include <utility>

namespace pongsim::web {

namespace {

// Size of a piece of a frame, which the library may have to keep while the socket is full.
constexpr std::size_t kPiece = std::size_t{64} << 10;
// After this many bytes other connections have their turn.
constexpr int kPiecesATurn = 8;
constexpr std::size_t kLongestReason = 123;
// The memory of a message up to this size is kept for the next one.
constexpr std::size_t kKeptMessage = std::size_t{64} << 10;

/// Copies the part of a frame that starts at `begin` and fits.
void copyPart(const Frame& frame, std::size_t begin, std::span<unsigned char> place) {
  std::size_t done = 0;
  if (begin < frame.head.size()) {
    done = std::min(place.size(), frame.head.size() - begin);
    std::memcpy(place.data(), frame.head.data() + begin, done);
  }
  if (done == place.size()) return;
  const std::size_t inBody = begin + done - frame.head.size();
  std::memcpy(place.data() + done, frame.body.bytes().data() + inBody, place.size() - done);
}

}  // namespace

Connection::Connection(std::shared_ptr<Waker> waker, lws* socket, const ServerLimits& limits, bool mayWrite,
                       std::shared_ptr<ClientTraffic> traffic)
    : waker_(std::move(waker)), socket_(socket), limits_(limits), mayWrite_(mayWrite), traffic_(std::move(traffic)) {}

void Connection::add(ClientQueue::Item item) {
  if (hasEnded_ || isClosing()) return;
  if (queue_.add(std::move(item))) return wake();
  queue_.clear();
  close(LWS_CLOSE_STATUS_POLICY_VIOLATION, "it does not read its data");
}

void Connection::sendText(std::string text) { add({.isText = true, .frame = {.head = std::move(text), .body = {}}}); }

void Connection::sendBinary(Frame frame) { add({.isText = false, .frame = std::move(frame)}); }

void Connection::sendData(std::uint64_t key, std::size_t most, Frame frame) {
  if (hasEnded_ || isClosing()) return;
  queue_.addData(key, most, std::move(frame));
  wake();
}

void Connection::sendWhenFree(std::uint64_t key, std::function<Frame()> make) {
  if (hasEnded_ || isClosing()) return;
  queue_.addMaker(key, std::move(make));
  wake();
}

void Connection::forget(std::uint64_t key) { queue_.forget(key); }

void Connection::close(std::uint16_t code, std::string reason) {
  {
    const std::lock_guard lock(mutex_);
    if (closing_) return;
    reason.resize(std::min(reason.size(), kLongestReason));
    closing_ = {code, std::move(reason)};
  }
  wake();
}

bool Connection::isClosing() const {
  const std::lock_guard lock(mutex_);
  return closing_.has_value();
}

void Connection::wake() {
  if (hasEnded_ || isAwake_.exchange(true)) return;
  waker_->add(shared_from_this());
}

void Connection::called() {
  if (socket_ == nullptr) return;
  // later items request another write
  isAwake_ = false;
  if (isClosing()) lws_set_timeout(socket_, PENDING_TIMEOUT_CLOSE_SEND, static_cast<int>(limits_.handshake.count()));
  lws_callback_on_writable(socket_);
}

bool Connection::writePiece(std::vector<unsigned char>& buffer) {
  const std::size_t size = current_->frame.size();
  const std::size_t count = std::min(kPiece, size - written_);
  buffer.resize(LWS_PRE + kPiece);
  copyPart(current_->frame, written_, {buffer.data() + LWS_PRE, count});
  const bool isLast = written_ + count == size;
  const int flags =
      lws_write_ws_flags(current_->isText ? LWS_WRITE_TEXT : LWS_WRITE_BINARY, written_ == 0, isLast ? 1 : 0);
  if (lws_write(socket_, buffer.data() + LWS_PRE, count, static_cast<lws_write_protocol>(flags)) <
      static_cast<int>(count))
    return false;
  written_ += count;
  if (!isLast) return true;
  traffic_->add(current_->key, size);
  current_.reset();
  return true;
}

bool Connection::write(std::vector<unsigned char>& buffer) {
  for (int i = 0; i < kPiecesATurn; ++i) {
    if (!current_) {
      current_ = queue_.take();
      written_ = 0;
      if (!current_) break;
    }
    if (!writePiece(buffer)) return false;
    if (lws_send_pipe_choked(socket_) != 0) break;
  }
  if (current_ || !queue_.isEmpty()) {
    lws_callback_on_writable(socket_);
    return true;
  }
  const std::lock_guard lock(mutex_);
  return closing_ ? closeNow(*closing_) : true;
}

bool Connection::closeNow(const Closing& closing) {
  std::string reason = closing.reason;
  lws_close_reason(socket_, static_cast<lws_close_status>(closing.code),
                   reinterpret_cast<unsigned char*>(reason.data()), reason.size());
  return false;
}

void Connection::receive(std::string_view part, std::size_t rest, bool isLastPiece, bool isBinary, const Logger& log) {
  if (isClosing()) return;
  const std::size_t room = limits_.messageBytes - message_.size();
  if (isTooLong_ || part.size() > room || rest > room - part.size()) return dropTooLong(rest);
  const bool isWhole = rest == 0 && isLastPiece;
  if (isWhole && message_.empty()) {
    deliver(part, isBinary, log);
    return;
  }
  message_.append(part);
  if (isWhole) {
    deliver(message_, isBinary, log);
    message_.clear();
    if (message_.capacity() > kKeptMessage) message_.shrink_to_fit();
  }
}

void Connection::dropTooLong(std::size_t rest) {
  message_ = {};
  if (!isTooLong_) lws_set_timeout(socket_, PENDING_TIMEOUT_CLOSE_SEND, static_cast<int>(limits_.handshake.count()));
  isTooLong_ = true;
  // if the connection were closed before, the system would reset it, and the client would not get the reason
  if (rest > 0) return;
  close(LWS_CLOSE_STATUS_MESSAGE_TOO_LARGE,
        "a message can have up to " + std::to_string(limits_.messageBytes) + " bytes");
}

void Connection::deliver(std::string_view message, bool isBinary, const Logger& log) {
  if (!session_) return;
  try {
    if (isBinary) {
      session_->binary(std::as_bytes(std::span(message)));
    } else {
      session_->text(message);
    }
  } catch (const std::exception& error) {
    log.warning(std::string("a client's message can't be handled: ") + error.what());
    close(LWS_CLOSE_STATUS_UNEXPECTED_CONDITION, "the server has failed");
  }
}

void Connection::ended() {
  hasEnded_ = true;
  socket_ = nullptr;
  session_.reset();
  queue_.clear();
  current_.reset();
}

}  // namespace pongsim::web
