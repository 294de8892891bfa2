#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::fuel {

/// The head of a server's response.
struct Answer {
  int status = 0;
  /// The final address, after redirections.
  std::string url;
  /// Keys are header names in lower case.
  std::map<std::string, std::string> headers;

  /// @return The value; empty if there is no such header.
  std::string header(const std::string& name) const;
  /// @return Size of the body in bytes; 0 if the server does not give it.
  std::uint64_t length() const;
};

struct Request {
  std::string url;
  std::string method = "GET";
  /// Headers with credentials: sent only to the server of `url`, not to the targets of redirections.
  std::vector<std::string> secrets = {};
  std::vector<std::string> headers = {};
};

/// Makes HTTP requests with libcurl, one at a time; a process may have several instances.
///
/// Certificates are verified with those of the system, or those in SSL_CERT_FILE. Proxies are taken from the
/// environment. Up to ten redirections are followed, but none from https to http. A transfer of less than 100 bytes/s
/// over PONGSIM_FUEL_TIMEOUT seconds (default 30) fails.
class Http {
 public:
  using Begin = std::function<void(const Answer&)>;
  using Take = std::function<void(std::string_view)>;

  Http();
  ~Http();
  Http(const Http&) = delete;
  Http& operator=(const Http&) = delete;

  /// @param begin Called once with the final response, before its body, if its status is below 300.
  /// @param take Called with each part of the body. An exception from either ends the request.
  /// @return The response, whatever its status.
  /// @throws PassingFailure, Failure if there is none, or only a part of one; Interrupted.
  Answer send(const Request& request, const Begin& begin, const Take& take);

  /// @return The body, of at most `most` bytes.
  /// @throws Like `send`, and if the status is not a success: see `refuse`.
  std::string text(const Request& request, std::size_t most = std::size_t{64} << 20U);

 private:
  struct Transfer;
  bool sendOnce(const Request& request, bool isFirst, Transfer& transfer);

  void* curl_;
};

/// @throws Failure, PassingFailure that explains the status code of a response.
[[noreturn]] void refuse(const Answer& answer);

/// @return The scheme, host and port of an address: "https://fuel.gazebosim.org".
std::string originOf(std::string_view url);

}  // namespace pongsim::fuel
