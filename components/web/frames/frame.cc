#include "web/frames/frame.hh"

#include <bit>
#include <cassert>
#include <cstring>

namespace pongsim::web {

namespace {

static_assert(std::endian::native == std::endian::little, "frames are written as memory has them");

template <class Number>
void put(std::span<std::byte> place, std::size_t at, Number number) {
  std::memcpy(place.data() + at, &number, sizeof number);
}

}  // namespace

Payload encodeFrame(const FrameStatus& status, std::span<const FramePose> now, std::vector<FramePose>& before) {
  const bool hasAll = before.size() != now.size();
  if (hasAll) before.assign(now.size(), FramePose{});
  // count moved entities first, to allocate once
  std::size_t count = 0;
  for (std::size_t i = 0; i < now.size(); ++i) count += hasAll || now[i] != before[i] ? 1 : 0;
  Payload payload(kFrameHead + count * kFrameEntry);
  const std::span<std::byte> bytes = payload.bytes();
  put(bytes, 0, kFrameMagic);
  put(bytes, 4, hasAll ? kFrameHasAll : std::uint32_t{0});
  put(bytes, 8, status.timeNs);
  put(bytes, 16, status.iterations);
  put(bytes, 24, status.realTimeFactor);
  put(bytes, 32, static_cast<std::uint32_t>(status.isPaused));
  put(bytes, 36, std::uint32_t{0});
  put(bytes, 40, status.revision);
  put(bytes, 44, static_cast<std::uint32_t>(count));
  std::size_t at = kFrameHead;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (!hasAll && now[i] == before[i]) continue;
    std::memcpy(bytes.data() + at, &now[i], kFrameEntry);
    at += kFrameEntry;
    before[i] = now[i];
  }
  assert(at == bytes.size());
  return payload;
}

}  // namespace pongsim::web
