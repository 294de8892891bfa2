#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::web {

/// Bytes that several clients share. A copy is the same bytes.
class Payload {
 public:
  Payload() = default;
  /// Of so many bytes, which stand for nothing yet.
  explicit Payload(std::size_t size) : bytes_(std::make_shared_for_overwrite<std::byte[]>(size)), size_(size) {}
  explicit Payload(std::string_view text);

  /// For who has made it, before anybody else has it.
  std::span<std::byte> bytes() { return {bytes_.get(), size_}; }
  std::span<const std::byte> bytes() const { return {bytes_.get(), size_}; }
  std::size_t size() const { return size_; }

 private:
  std::shared_ptr<std::byte[]> bytes_;
  std::size_t size_ = 0;
};

/// A binary message of a WebSocket: what is the client's own, then what it shares with others.
struct Frame {
  std::string head;
  Payload body;

  std::size_t size() const { return head.size() + body.size(); }
};

/// What is to be called on the server's thread.
class Callee {
 public:
  virtual ~Callee() = default;
  virtual void called() = 0;
};

/// One connection, for who sends. Functions may be called from any thread, return at once and wait for nobody; once
/// the connection has ended they do nothing. A client that does not read never holds more than
/// `ServerLimits::waitingBytes`.
class Client {
 public:
  virtual ~Client() = default;

  /// Sends what must not be lost: a list, an answer. A client that lets too much of that wait is closed (1008).
  virtual void sendText(std::string text) = 0;
  virtual void sendBinary(Frame frame) = 0;

  /// Sends data. Of one key at most `most` frames wait, at least 1; of more the oldest goes. With 1 only the latest
  /// waits, in the place of the one before it: for poses, images and whatever else is a state. Frames for which there
  /// is no room in `ServerLimits::waitingBytes` are dropped, too.
  /// @param key Whatever the session numbers its subscriptions by.
  virtual void sendData(std::uint64_t key, std::size_t most, Frame frame) = 0;

  /// As `sendData` with 1, but the frame is made on the server's thread at the moment when the socket can take it: for
  /// what depends on what this client has already got. An empty frame is not sent.
  /// @param make Must hold what it needs; called once, or not at all.
  virtual void sendWhenFree(std::uint64_t key, std::function<Frame()> make) = 0;

  /// Has somebody called soon on the server's thread, whatever becomes of this connection; not at all where the server
  /// ends. Cheap: for the thread of a simulation, which leaves work to the server's.
  virtual void callSoon(std::shared_ptr<Callee> callee) = 0;

  /// Has somebody called some 120 times a second of wall time, until what is returned is destroyed or the server ends:
  /// for what the server's thread goes and sees itself, so that others need not wake it. For the server's thread.
  virtual std::shared_ptr<void> callRegularly(std::weak_ptr<Callee> callee) = 0;

  /// Drops what waits of that key: its subscription has ended.
  virtual void forget(std::uint64_t key) = 0;

  /// Closes the connection, after what must not be lost has left.
  /// @param code As of RFC 6455: 1008 for what is not allowed, 1011 for a fault of ours.
  /// @param reason Up to 123 bytes, else cut.
  virtual void close(std::uint16_t code, std::string reason) = 0;

  /// @return Whether it may change anything: publish, call services that change something, set parameters.
  virtual bool mayWrite() const = 0;

  /// @return Data frames that were dropped for this client so far.
  virtual std::uint64_t dropped() const = 0;
};

/// What a protocol does with one client: it lives from the handshake to the end of the connection. All functions are
/// called on the server's thread, one at a time, and must not block. What they throw closes the connection (1011), with
/// a warning.
class Session {
 public:
  virtual ~Session() = default;

  /// A whole text message, valid UTF-8, up to `ServerLimits::messageBytes`.
  virtual void text(std::string_view message) = 0;
  /// A whole binary message.
  virtual void binary(std::span<const std::byte> message) = 0;
};

/// What clients of one kind speak. It outlives its sessions.
class Protocol {
 public:
  virtual ~Protocol() = default;

  /// @return The WebSocket subprotocols by which clients ask for it, the preferred one first; "" stands for a client
  /// that names none.
  virtual std::vector<std::string> names() const = 0;

  /// A client has come. Called on the server's thread.
  /// @param name Which of the names it has asked for.
  /// @param client There as long as somebody holds it.
  virtual std::unique_ptr<Session> open(const std::string& name, const std::shared_ptr<Client>& client) = 0;
};

/// A file that a world needs to be drawn.
struct Asset {
  std::string bytes;
  /// "model/gltf-binary"
  std::string mediaType;
  /// Why there is none; empty where there is one.
  std::string error;
};

/// Where meshes, textures and the like come from. For any thread.
class AssetSource {
 public:
  virtual ~AssetSource() = default;
  /// @param address As the scene has it: a path, "file://...", "model://...", an address of Fuel.
  virtual Asset fetch(std::string_view address) const = 0;
};

/// A channel that pongsim's own page is offered (subprotocol `pongsim.web.v1`) and no other client, with the encoding
/// "pongsim": such as the poses of a world. Called on the server's thread.
class OwnChannel {
 public:
  virtual ~OwnChannel() = default;
  /// @return "/world/shapes/frame"
  virtual std::string topic() const = 0;
  /// @return What stands for the schema's name: "pongsim.Frame".
  virtual std::string schemaName() const = 0;
  /// A client subscribes. It gets frames by `sendWhenFree(key, ...)` until what is returned is destroyed.
  /// @param head Makes what the protocol puts in front of a frame of that time of the simulation [ns].
  virtual std::shared_ptr<void> open(const std::shared_ptr<Client>& client, std::uint64_t key,
                                     std::function<std::string(std::uint64_t timeNs)> head) = 0;
};

/// The own channels that there are now, those of all worlds. For any thread.
class OwnChannels {
 public:
  virtual ~OwnChannels() = default;
  virtual std::vector<std::shared_ptr<OwnChannel>> all() const = 0;
  /// @return A number that is another one when a channel has come or gone. Cheap.
  virtual std::uint64_t version() const = 0;
};

}  // namespace pongsim::web
