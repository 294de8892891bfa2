#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "pongsim/outcome.hh"
#include "web/rosbridge/definition.hh"

namespace pongsim::web::rosbridge {

/// How clients get lists of numbers.
enum class Form {
  /// As lists; bytes (`uint8[]`) as a text in base64.
  kJson,
  /// As typed arrays (RFC 8746), which CBOR can have.
  kCbor
};

/// @param payload In plain CDR (XCDR1), as ROS 2 has it, little-endian.
/// @return The message; null if the payload is too short for the type.
nlohmann::json readCdr(const RosDefinition& definition, std::span<const std::byte> payload, Form form);

/// @param message From a client; not trusted. Fields that are missing are zero or empty. Bytes may be a list or base64.
/// @return The payload in CDR; or what is wrong: "linear.x is not a number".
Outcome<std::string> writeCdr(const RosDefinition& definition, const nlohmann::json& message);

}  // namespace pongsim::web::rosbridge
