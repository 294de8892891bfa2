#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "log/mcap/definition.hh"
#include "pongsim/message.hh"

namespace pongsim::log {

/// Decodes the messages of one topic, whose type is described in the file or known to this program.
class Decoder {
 public:
  virtual ~Decoder() = default;

  /// @return The message, valid until the next call.
  /// @throws Failure if the payload is invalid.
  virtual const Message& decode(std::string_view payload) = 0;

  /// An empty message, for its list of fields.
  virtual const Message& prototype() const = 0;

  /// @return The message as one line of JSON.
  virtual std::string jsonOf(const Message& message) const = 0;
};

/// @param type Full name.
/// @throws Failure if messages with this definition can't be decoded.
std::unique_ptr<Decoder> makeDecoder(const Definition& definition, const std::string& type);

}  // namespace pongsim::log
