#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "pongsim/bulk.hh"
#include "pongsim/message.hh"

namespace pongsim::msgs {

/// @return The full name of the message's type.
const std::string& typeName(const Message& message);

/// @return How many bytes `writeBytes` writes.
std::size_t byteSize(const Message& message);

/// Writes the message in protobuf's binary form, at once after `byteSize`, whose result is the size of `place`.
void writeBytes(const Message& message, std::span<std::byte> place);

/// Writes a message whose bulk is elsewhere, in protobuf's binary form. Both must outlive it.
class BulkWriter {
 public:
  /// @return Nothing where the message has no such field of bytes.
  static std::optional<BulkWriter> of(const Message& message, const Bulk& bulk);

  /// @return How many bytes `write` writes.
  std::size_t size() const { return head_ + tagSize_ + bulk_->size; }
  void write(std::span<std::byte> place) const;

 private:
  BulkWriter(const Message& message, const Bulk& bulk) : message_(&message), bulk_(&bulk) {}

  const Message* message_;
  const Bulk* bulk_;
  std::size_t head_ = 0;
  /// The field's number and length, which stand before its bytes.
  std::array<std::byte, 16> tag_{};
  std::size_t tagSize_ = 0;
};

/// Replaces `message` by what the bytes say.
/// @return Whether they are a message of its type.
bool parseBytes(std::span<const std::byte> bytes, Message& message);

}  // namespace pongsim::msgs
