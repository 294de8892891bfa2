#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pongsim::web::test {

/// A client on a bare socket that sends whatever it is told, valid or not. Waits up to a minute for an answer.
class RawClient {
 public:
  /// @param receiveBuffer Of the socket [bytes]; 0: the system's default.
  explicit RawClient(int port, int receiveBuffer = 0);
  ~RawClient();
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  bool isConnected() const { return socket_ >= 0; }
  /// @return Whether everything was accepted.
  bool send(std::string_view bytes);

  /// Requests a path, with additional header lines ("Name: value\r\n"), and reads the response until the server closes
  /// the connection.
  std::string get(const std::string& path, const std::string& headers = {}, const std::string& host = {});
  /// Requests a WebSocket.
  /// @param headers As above, with `Sec-WebSocket-Protocol` and `Origin` if needed.
  /// @return The response's header, which starts with "HTTP/1.1 101" on success.
  std::string open(const std::string& path = "/", const std::string& headers = {}, const std::string& host = {});

  /// Sends one frame, masked as clients must.
  bool sendFrame(int opcode, std::string_view payload, bool isFinal = true);
  bool sendText(std::string_view text) { return sendFrame(1, text); }
  bool sendBinary(std::string_view bytes) { return sendFrame(2, bytes); }

  struct Message {
    int opcode = 0;
    std::string payload;
    /// For opcode 8.
    int closeCode() const;
  };
  /// @return The next message, with all its fragments; nothing if the connection has ended.
  std::optional<Message> next();

  /// Ends this side of the connection and reads what still comes.
  /// @return Whether the server has ended its side too.
  bool finish();

 private:
  bool readExactly(void* place, std::size_t size);

  int port_;
  int socket_ = -1;
};

}  // namespace pongsim::web::test
