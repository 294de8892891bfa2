#include "video/stream.hh"

#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace pongsim::video {

namespace {

/// @return Whether all bytes could be read before the file's end.
bool fill(int input, std::span<std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::read(input, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace

Outcome<void> encodeStream(int input, std::size_t imageSize, Encoder& encoder) {
  std::int64_t frame = -1;
  std::vector<std::uint8_t> bytes(sizeof frame + imageSize);
  while (fill(input, bytes)) {
    std::memcpy(&frame, bytes.data(), sizeof frame);
    if (Outcome<void> added = encoder.add(frame, std::span(bytes).subspan(sizeof frame)); !added) return added;
  }
  if (frame < 0) return {"'" + encoder.place().string() + "' would have no pictures"};
  return encoder.complete();
}

}  // namespace pongsim::video
