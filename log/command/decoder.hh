#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "log/mcap/definition.hh"
#include "pongsim/message.hh"

namespace pongsim::log {

/// Reads the messages of one topic, whose type a file describes or this program knows.
class Decoder {
 public:
  virtual ~Decoder() = default;

  /// @return The message, there until the next call.
  /// @throws Failure where the payload is none.
  virtual const Message& decode(std::string_view payload) = 0;

  /// An empty one, which tells the fields.
  virtual const Message& prototype() const = 0;

  /// @return The message as one line of JSON.
  virtual std::string jsonOf(const Message& message) const = 0;
};

/// @param type Full name.
/// @throws Failure where messages of that definition can't be read.
std::unique_ptr<Decoder> makeDecoder(const Definition& definition, const std::string& type);

}  // namespace pongsim::log
