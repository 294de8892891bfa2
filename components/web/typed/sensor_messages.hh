#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace google::protobuf {
class Descriptor;
}

namespace pongsim::web::typed {

/// Converts a world's serialized message to a serialized Foxglove message.
/// @param timeNs Simulated time for messages without a stamp [ns].
/// @return Nothing if the bytes are not a valid message, or Foxglove can't represent it.
using Conversion = std::optional<std::string> (*)(std::span<const std::byte> message, std::uint64_t timeNs);

struct Converted {
  /// The resulting message type: foxglove.RawImage.
  const google::protobuf::Descriptor& type;
  Conversion convert;
};

/// @param type Full name of a message type: images, camera info, laser scans, point clouds, positions on earth.
/// @return Nothing for other types.
std::optional<Converted> conversionOf(std::string_view type);

}  // namespace pongsim::web::typed
