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

/// Makes a message of Foxglove, in its binary form, of one of the world's in that form.
/// @param timeNs Simulated time for a message that has none [ns].
/// @return Nothing where the bytes are no such message, or say what Foxglove has no words for.
using Conversion = std::optional<std::string> (*)(std::span<const std::byte> message, std::uint64_t timeNs);

struct Converted {
  /// What the messages become: foxglove.RawImage.
  const google::protobuf::Descriptor& type;
  Conversion convert;
};

/// @param type Full name of a message type: images, what is known of cameras, scans, clouds, places on the earth.
/// @return Nothing of other types.
std::optional<Converted> conversionOf(std::string_view type);

}  // namespace pongsim::web::typed
