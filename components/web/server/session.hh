#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace pongsim::web {

class ClientTraffic;

/// Bytes shared by several clients. Copies refer to the same bytes.
class Payload {
 public:
  Payload() = default;
  /// Allocates this many uninitialized bytes.
  explicit Payload(std::size_t size) : bytes_(std::make_shared_for_overwrite<std::byte[]>(size)), size_(size) {}
  explicit Payload(std::string_view text);

  /// Only for the creator, before anybody else has it.
  std::span<std::byte> bytes() { return {bytes_.get(), size_}; }
  std::span<const std::byte> bytes() const { return {bytes_.get(), size_}; }
  std::size_t size() const { return size_; }

 private:
  std::shared_ptr<std::byte[]> bytes_;
  std::size_t size_ = 0;
};

/// A WebSocket message: a part of the client's own, then the part shared with others.
struct Frame {
  std::string head;
  Payload body;
  /// Valid UTF-8, instead of bytes.
  bool isText = false;

  std::size_t size() const { return head.size() + body.size(); }
};

/// Something to call on the server's thread.
class Callee {
 public:
  virtual ~Callee() = default;
  virtual void called() = 0;
};

/// A connection, seen by the sender. Functions can be called from any thread and never block; after the connection has
/// ended they do nothing. At most `ServerLimits::waitingBytes` are queued for a client that does not read.
class Client {
 public:
  virtual ~Client() = default;

  /// Sends data that must not be lost: a list, a reply. A client with too much of it queued is closed (1008).
  virtual void sendText(std::string text) = 0;
  virtual void sendBinary(Frame frame) = 0;

  /// Sends data that may be dropped. At most `most` frames, at least 1, are queued for each key; of more, the oldest is
  /// dropped. With 1, only the latest is queued, in its predecessor's place: for poses, images and other states. Frames
  /// that exceed `ServerLimits::waitingBytes` are dropped too.
  /// @param key Any number by which the session identifies its subscription.
  virtual void sendData(std::uint64_t key, std::size_t most, Frame frame) = 0;

  /// Like `sendData` with 1, but the frame is made on the server's thread at the moment when the socket can take it:
  /// for data that depends on what this client has already received. Empty frames are not sent.
  /// @param make Must keep alive what it uses; called at most once.
  virtual void sendWhenFree(std::uint64_t key, std::function<Frame()> make) = 0;

  /// Schedules a call on the server's thread, even if this connection ends first; dropped only if the server ends.
  /// Cheap, so that a simulation's thread can leave work to the server's.
  virtual void callSoon(std::shared_ptr<Callee> callee) = 0;

  /// Schedules calls some 120 times per second of wall time, until the result is destroyed or the server ends: for data
  /// that the server's thread polls, so that nobody has to wake it. For the server's thread.
  virtual std::shared_ptr<void> callRegularly(std::weak_ptr<Callee> callee) = 0;

  /// Drops what is queued for this key: its subscription has ended.
  virtual void forget(std::uint64_t key) = 0;

  /// Closes the connection after sending what must not be lost.
  /// @param code By RFC 6455: 1008 for a policy violation, 1011 for an internal error.
  /// @param reason Up to 123 bytes; cut if longer.
  virtual void close(std::uint16_t code, std::string reason) = 0;

  /// @return Whether it may change anything: publish, call services that have an effect, set parameters.
  virtual bool mayWrite() const = 0;

  /// @return Number of data frames dropped for this client so far.
  virtual std::uint64_t dropped() const = 0;

  /// @return What it has been sent. A session names the topics of its keys there.
  virtual ClientTraffic& traffic() = 0;
};

/// A protocol's state for one client, from the handshake to the end of the connection. All functions are called on the
/// server's thread, one at a time, and must not block. An exception closes the connection (1011), with a warning.
class Session {
 public:
  virtual ~Session() = default;

  /// A complete text message, valid UTF-8, up to `ServerLimits::messageBytes`.
  virtual void text(std::string_view message) = 0;
  /// A complete binary message.
  virtual void binary(std::span<const std::byte> message) = 0;
};

/// A protocol that clients use. Outlives its sessions.
class Protocol {
 public:
  virtual ~Protocol() = default;

  /// @return The WebSocket subprotocols for which clients use it, the preferred one first; "" means a client that names
  /// none.
  virtual std::vector<std::string> names() const = 0;

  /// Creates the session of a new client. Called on the server's thread.
  /// @param name The name that the client requested.
  /// @param client Exists as long as somebody holds it.
  virtual std::unique_ptr<Session> open(const std::string& name, const std::shared_ptr<Client>& client) = 0;
};

/// A file needed to draw a world.
struct Asset {
  std::string bytes;
  /// "model/gltf-binary"
  std::string mediaType;
  /// Why it is not available; empty on success.
  std::string error;
};

/// Provides meshes, textures and the like. For any thread.
class AssetSource {
 public:
  virtual ~AssetSource() = default;
  /// @param address As in the scene: a path, "file://...", "model://...", a Fuel address.
  virtual Asset fetch(std::string_view address) const = 0;
};

/// A channel offered only to pongsim's own page (subprotocol `pongsim.web.v1`), with the encoding "pongsim": for
/// example a world's poses. Called on the server's thread.
class OwnChannel {
 public:
  virtual ~OwnChannel() = default;
  /// @return "/world/shapes/frame"
  virtual std::string topic() const = 0;
  /// @return Name of the schema: "pongsim.Frame".
  virtual std::string schemaName() const = 0;
  /// Subscribes a client, which gets frames by `sendWhenFree(key, ...)` until the result is destroyed.
  /// @param head Creates the protocol's header of a frame with this simulated time [ns].
  virtual std::shared_ptr<void> open(const std::shared_ptr<Client>& client, std::uint64_t key,
                                     std::function<std::string(std::uint64_t timeNs)> head) = 0;
  /// The client asks for the next message of a subscription, and says what it wants.
  /// @param opened The result of `open`.
  /// @return What is wrong, as a sentence without a full stop, or an empty text.
  virtual std::string ask(const std::shared_ptr<void>& opened, const nlohmann::json& wish) = 0;
};

/// The current own channels of all worlds. For any thread.
class OwnChannels {
 public:
  virtual ~OwnChannels() = default;
  virtual std::vector<std::shared_ptr<OwnChannel>> all() const = 0;
  /// @return A number that changes when a channel is added or removed. Cheap.
  virtual std::uint64_t version() const = 0;
};

}  // namespace pongsim::web
