#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace pongsim::log {

// The numbers of MCAP are little endian, its texts have their length in front.

/// Appends to bytes.
class ByteWriter {
 public:
  explicit ByteWriter(std::string& bytes) : bytes_(bytes) {}

  template <std::unsigned_integral Number>
  void number(Number value) {
    for (std::size_t i = 0; i < sizeof(Number); ++i) bytes_ += static_cast<char>(value >> (8 * i) & 0xffU);
  }
  /// @throws Failure where it is longer than MCAP can say: 4 GiB.
  void text(std::string_view value);
  void raw(std::string_view value) { bytes_ += value; }

 private:
  std::string& bytes_;
};

/// Reads what may be damaged, or lie.
class ByteReader {
 public:
  /// @param bytes Must outlive it.
  /// @param offset Where they stand in the file; @param what They are, as "chunk": both for errors.
  ByteReader(std::string_view bytes, std::uint64_t offset, std::string_view what)
      : bytes_(bytes), offset_(offset), what_(what) {}

  template <std::unsigned_integral Number>
  Number number() {
    const std::string_view from = raw(sizeof(Number));
    Number value = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      value = static_cast<Number>(
          value | static_cast<Number>(static_cast<Number>(static_cast<unsigned char>(from[i])) << (8 * i)));
    }
    return value;
  }
  /// With its length in four bytes.
  std::string_view text();
  /// @throws Failure where so many are not left.
  std::string_view raw(std::uint64_t size);
  std::string_view rest();
  /// @return A reader of the next bytes, which passes them here.
  ByteReader part(std::uint64_t size);

  bool isAtEnd() const { return at_ == bytes_.size(); }
  /// In the file.
  std::uint64_t offset() const { return offset_ + at_; }
  std::size_t position() const { return at_; }
  /// @throws Failure that says where the reader is.
  [[noreturn]] void fail(const std::string& why) const;

 private:
  std::string_view bytes_;
  std::uint64_t offset_;
  std::string_view what_;
  std::size_t at_ = 0;
};

/// @return "byte 1234: WHY", which an error says after the file's name.
std::string atByte(std::uint64_t offset, const std::string& why);

}  // namespace pongsim::log
