#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace pongsim::shared {

/// A part of an RTPS message (RTPS 2.3, 9.4.5).
struct Submessage {
  std::uint8_t kind = 0, flags = 0;
  /// The bytes after its header, a view into the message.
  std::span<const std::uint8_t> content;

  bool isLittleEndian() const { return (flags & 1) != 0; }
};

/// Reads the submessages of an RTPS message in order, with the boundaries that Fast DDS finds.
class Submessages {
 public:
  /// Size of the message header (RTPS 2.3, 9.4.1).
  static constexpr std::size_t kMessageHeader = 20;

  /// @param packet Any bytes; without an RTPS header there are no submessages.
  explicit Submessages(std::span<const std::uint8_t> packet);

  /// @return The next one; nothing at the end, and if the next one exceeds the message.
  std::optional<Submessage> next();

  /// @return Whether the last one exceeded the message.
  bool isCutOff() const { return isCutOff_; }

 private:
  std::span<const std::uint8_t> rest_;
  bool isCutOff_ = false;
};

/// @return Whether the bytes begin with the header of an RTPS message.
bool isRtpsMessage(std::span<const std::uint8_t> packet);

}  // namespace pongsim::shared
