#include "ros2/types/cdr.hh"

#include <algorithm>

namespace pongsim::ros2 {

namespace {
static_assert(std::endian::native == std::endian::little);

// identifiers of encodings: OMG DDS-XTypes 1.3, table 60
constexpr std::uint8_t kBigEndian1 = 0x00, kLittleEndian1 = 0x01, kBigEndian2 = 0x06, kLittleEndian2 = 0x07;
}  // namespace

CdrWriter::CdrWriter(std::span<std::byte> place) : place_(place.subspan(kEncapsulation)) {
  std::ranges::fill(place.first(kEncapsulation), std::byte(0));
  place[1] = std::byte(kLittleEndian1);
}

CdrReader::CdrReader(std::span<const std::byte> payload) {
  if (payload.size() < kEncapsulation) {
    fail("it has " + std::to_string(payload.size()) + " bytes, too few for its encoding");
    return;
  }
  const auto kind = std::to_integer<std::uint8_t>(payload[1]);
  const bool isVersion2 = kind == kBigEndian2 || kind == kLittleEndian2;
  if (payload[0] != std::byte(0) || (kind != kBigEndian1 && kind != kLittleEndian1 && !isVersion2)) {
    fail("its encoding is not plain CDR");
    return;
  }
  isSwapped_ = kind == kBigEndian1 || kind == kBigEndian2;
  if (isVersion2) largestAlignment_ = 4;
  bytes_ = payload.subspan(kEncapsulation);
}

void CdrReader::fail(const std::string& what) {
  if (error_) return;
  error_ = field_ == nullptr ? what : "field '" + std::string(field_) + "' " + what;
}

bool CdrReader::take(void* to, std::size_t size, std::size_t count) {
  const std::size_t alignment = std::min(size, largestAlignment_);
  const std::size_t begin = (at_ + alignment - 1) / alignment * alignment;
  if (begin > bytes_.size() || (bytes_.size() - begin) / size < count) {
    fail("is cut off");
    return false;
  }
  if (count > 0) std::memcpy(to, bytes_.data() + begin, size * count);
  at_ = begin + size * count;
  return true;
}

bool CdrReader::isCredible(std::uint32_t count, std::size_t leastSize, std::size_t most) {
  const std::size_t left = bytes_.size() - at_;
  if (count > left / std::max<std::size_t>(leastSize, 1)) {
    fail("claims " + std::to_string(count) + " elements, but " + std::to_string(left) + " bytes are left");
  } else if (most > 0 && count > most) {
    fail("has " + std::to_string(count) + " elements, but may have " + std::to_string(most));
  }
  return !error_;
}

void CdrReader::readText(std::string& text, std::size_t most) {
  std::uint32_t size = 0;
  read(size);
  if (error_) return;
  if (size > bytes_.size() - at_) {
    fail("claims " + std::to_string(size) + " characters, but " + std::to_string(bytes_.size() - at_) +
         " bytes are left");
    return;
  }
  // an empty text has one byte, its terminating zero; some writers leave that out
  const char* begin = reinterpret_cast<const char*>(bytes_.data() + at_);
  if (size > 0 && begin[size - 1] != '\0') {
    fail("is a string without an end");
    return;
  }
  const std::size_t length = size > 0 ? size - 1 : 0;
  if (most > 0 && length > most) {
    fail("has " + std::to_string(length) + " characters, but may have " + std::to_string(most));
    return;
  }
  text.assign(begin, length);
  at_ += size;
}

}  // namespace pongsim::ros2
