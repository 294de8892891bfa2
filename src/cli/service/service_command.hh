#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace pongsim::cli {

struct CallOptions {
  std::string service;
  /// Full names; empty: as advertised by the service.
  std::string requestType;
  std::string replyType;
  /// The request in protobuf's text format.
  std::string text;
  /// Print the reply as JSON.
  bool asJson = false;
  /// For everything together; unset: one second to find the service, and five for the answer.
  std::optional<std::chrono::nanoseconds> timeout;
};

/// Implements `pongsim service`; each function returns the exit code.
int listServices(bool asJson, bool asGz);
/// @param asGz Name types as `gz` does.
int showService(const std::string& service, bool asJson, bool asGz);
int callService(const CallOptions& options);

}  // namespace pongsim::cli
