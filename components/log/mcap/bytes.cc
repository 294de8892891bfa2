#include "log/mcap/bytes.hh"

#include <limits>

#include "log/store/failure.hh"

namespace pongsim::log {

std::string atByte(std::uint64_t offset, const std::string& why) {
  return "byte " + std::to_string(offset) + ": " + why;
}

void ByteWriter::text(std::string_view value) {
  if (value.size() > std::numeric_limits<std::uint32_t>::max()) throw Failure("a string is larger than 4 GiB");
  number(static_cast<std::uint32_t>(value.size()));
  raw(value);
}

std::string_view ByteReader::raw(std::uint64_t size) {
  const std::size_t left = bytes_.size() - at_;
  if (size > left) {
    fail("the " + std::string(what_) + " should have " + std::to_string(size) + " more bytes, but has " +
         std::to_string(left));
  }
  const std::string_view taken = bytes_.substr(at_, size);
  at_ += size;
  return taken;
}

std::string_view ByteReader::text() { return raw(number<std::uint32_t>()); }

std::string_view ByteReader::rest() { return raw(bytes_.size() - at_); }

ByteReader ByteReader::part(std::uint64_t size) {
  const std::uint64_t start = offset();
  return {raw(size), start, what_};
}

void ByteReader::fail(const std::string& why) const { throw Failure(atByte(offset(), why)); }

}  // namespace pongsim::log
