#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace pongsim::ros2 {

/// @return The number in the bytes, of which there are at most eight.
std::uint64_t numberIn(std::span<const unsigned char> bytes, bool isLittleEndian);

/// Writes the number's last bytes, as many as there are.
void putNumber(std::span<unsigned char> bytes, bool isLittleEndian, std::uint64_t number);

/// A part of an RTPS message (RTPS 2.3, 9.4.5).
struct Submessage {
  unsigned char kind = 0, flags = 0;
  /// What follows its header; in the message, where it can be changed.
  std::span<unsigned char> content;

  bool isLittleEndian() const { return (flags & 1) != 0; }
};

/// The submessages of an RTPS message, one after the other, as Fast DDS divides it.
class Submessages {
 public:
  /// Its header's size (RTPS 2.3, 9.4.1).
  static constexpr std::size_t kMessageHeader = 20;

  /// @param packet Any bytes. Those that are no RTPS message have no submessages.
  explicit Submessages(std::span<unsigned char> packet);

  /// @return Nothing at the end, and where one is longer than the message.
  std::optional<Submessage> next();

 private:
  std::span<unsigned char> rest_;
};

/// @return Whether the bytes begin as an RTPS message does, and are long enough for its header.
bool isRtpsMessage(std::span<const unsigned char> packet);

}  // namespace pongsim::ros2
