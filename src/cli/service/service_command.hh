#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace pongsim::cli {

struct CallOptions {
  std::string service;
  /// Full names; empty: what the service says.
  std::string requestType;
  std::string replyType;
  /// The request, as protobuf's text.
  std::string text;
  /// Print the reply as JSON.
  bool asJson = false;
  /// For all of it; unset: a second to find the service, and five for the answer.
  std::optional<std::chrono::nanoseconds> timeout;
};

/// What `pongsim service` does; each returns the exit code.
int listServices(bool asJson);
int showService(const std::string& service, bool asJson);
int callService(const CallOptions& options);

}  // namespace pongsim::cli
