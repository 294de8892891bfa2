#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::fuel {

/// What a server says before the body.
struct Answer {
  int status = 0;
  /// Where it came from in the end.
  std::string url;
  /// By names in lower case.
  std::map<std::string, std::string> headers;

  /// @return Empty where there is none.
  std::string header(const std::string& name) const;
  /// @return Bytes of the body; 0 where the server does not say.
  std::uint64_t length() const;
};

struct Request {
  std::string url;
  std::string method = "GET";
  /// Those that tell who asks: they go to the server of `url` only, and not where it leads on to.
  std::vector<std::string> secrets = {};
  std::vector<std::string> headers = {};
};

/// Asks by HTTP, with libcurl. One at a time; a process may have several.
///
/// Certificates are checked against the system's, or those of SSL_CERT_FILE. Proxies are those of the environment.
/// Redirections are followed, up to ten, and never from https to http. A server that says next to nothing is given up
/// after PONGSIM_FUEL_TIMEOUT seconds (30).
class Http {
 public:
  using Begin = std::function<void(const Answer&)>;
  using Take = std::function<void(std::string_view)>;

  Http();
  ~Http();
  Http(const Http&) = delete;
  Http& operator=(const Http&) = delete;

  /// @param begin Called once with the answer that is not a redirection, before its body, if its status is below 300.
  /// @param take Called with the body, part by part. What either throws ends the request.
  /// @return The answer, whatever its status.
  /// @throws PassingFailure, Failure where there is none, or only a part of one; Interrupted.
  Answer send(const Request& request, const Begin& begin, const Take& take);

  /// @return The body, of at most `most` bytes.
  /// @throws As `send`, and where the status is not one of success: see `refuse`.
  std::string text(const Request& request, std::size_t most = std::size_t{64} << 20U);

 private:
  struct Transfer;
  bool sendOnce(const Request& request, bool isFirst, Transfer& transfer);

  void* curl_;
};

/// @throws Failure, PassingFailure that say what an answer's status means.
[[noreturn]] void refuse(const Answer& answer);

/// @return The scheme, host and port of an address: "https://fuel.gazebosim.org".
std::string originOf(std::string_view url);

}  // namespace pongsim::fuel
