#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace pongsim::shared {

/// A part of an RTPS message (RTPS 2.3, 9.4.5).
struct Submessage {
  std::uint8_t kind = 0, flags = 0;
  /// What follows its header, in the message.
  std::span<const std::uint8_t> content;

  bool isLittleEndian() const { return (flags & 1) != 0; }
};

/// The submessages of an RTPS message, one after the other, as Fast DDS divides it.
class Submessages {
 public:
  /// Its header's size (RTPS 2.3, 9.4.1).
  static constexpr std::size_t kMessageHeader = 20;

  /// @param packet Any bytes. Those that are no RTPS message have no submessages.
  explicit Submessages(std::span<const std::uint8_t> packet);

  /// @return Nothing at the end, and where one is longer than the message.
  std::optional<Submessage> next();

  /// @return Whether the last one was longer than the message.
  bool isCutOff() const { return isCutOff_; }

 private:
  std::span<const std::uint8_t> rest_;
  bool isCutOff_ = false;
};

/// @return Whether the bytes begin as an RTPS message does, and are long enough for its header.
bool isRtpsMessage(std::span<const std::uint8_t> packet);

}  // namespace pongsim::shared
