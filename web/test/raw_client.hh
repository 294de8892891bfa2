#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pongsim::web::test {

/// A client that does as it is told, right or wrong, with nothing but a socket. Waits up to a minute for an answer.
class RawClient {
 public:
  /// @param receiveBuffer Of the socket [bytes]; 0: as the system has it.
  explicit RawClient(int port, int receiveBuffer = 0);
  ~RawClient();
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  bool isConnected() const { return socket_ >= 0; }
  /// @return Whether all of it was taken.
  bool send(std::string_view bytes);

  /// Asks for a path, with more lines of headers ("Name: value\r\n"), and reads the answer until the server closes.
  std::string get(const std::string& path, const std::string& headers = {}, const std::string& host = {});
  /// Asks for a WebSocket.
  /// @param headers As above, with `Sec-WebSocket-Protocol` and `Origin` where they are wanted.
  /// @return The answer's head, which begins "HTTP/1.1 101" where it was granted.
  std::string open(const std::string& path = "/", const std::string& headers = {}, const std::string& host = {});

  /// Sends one frame, masked as clients do.
  bool sendFrame(int opcode, std::string_view payload, bool isFinal = true);
  bool sendText(std::string_view text) { return sendFrame(1, text); }
  bool sendBinary(std::string_view bytes) { return sendFrame(2, bytes); }

  struct Message {
    int opcode = 0;
    std::string payload;
    /// Of opcode 8.
    int closeCode() const;
  };
  /// @return The next message, of all its frames; nothing where the connection has ended.
  std::optional<Message> next();

 private:
  bool readExactly(void* place, std::size_t size);

  int port_;
  int socket_ = -1;
};

}  // namespace pongsim::web::test
