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

/// @return The number of bytes that `writeBytes` writes.
std::size_t byteSize(const Message& message);

/// Writes the message in protobuf's binary format. Call right after `byteSize`, whose result is the size of `place`.
void writeBytes(const Message& message, std::span<std::byte> place);

/// Writes a message whose bulk data is stored elsewhere, in protobuf's binary format. Both must outlive it.
class BulkWriter {
 public:
  /// @return Nothing if the message has no such bytes field.
  static std::optional<BulkWriter> of(const Message& message, const Bulk& bulk);

  /// @return The number of bytes that `write` writes.
  std::size_t size() const { return head_ + tagSize_ + bulk_->size; }
  void write(std::span<std::byte> place) const;

 private:
  BulkWriter(const Message& message, const Bulk& bulk) : message_(&message), bulk_(&bulk) {}

  const Message* message_;
  const Bulk* bulk_;
  std::size_t head_ = 0;
  /// The field's tag and length, which precede its bytes.
  std::array<std::byte, 16> tag_{};
  std::size_t tagSize_ = 0;
};

/// Replaces the content of `message` by the decoded bytes.
/// @return Whether they are a valid message of its type.
bool parseBytes(std::span<const std::byte> bytes, Message& message);

}  // namespace pongsim::msgs
