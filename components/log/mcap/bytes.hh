#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace pongsim::log {

// Numbers in MCAP are little endian, texts are preceded by their length.

/// Appends to a byte string.
class ByteWriter {
 public:
  explicit ByteWriter(std::string& bytes) : bytes_(bytes) {}

  template <std::unsigned_integral Number>
  void number(Number value) {
    for (std::size_t i = 0; i < sizeof(Number); ++i) bytes_ += static_cast<char>(value >> (8 * i) & 0xffU);
  }
  /// @throws Failure if it is longer than MCAP allows: 4 GiB.
  void text(std::string_view value);
  void raw(std::string_view value) { bytes_ += value; }

 private:
  std::string& bytes_;
};

/// Reads bytes that may be damaged or malicious.
class ByteReader {
 public:
  /// @param bytes Must outlive it.
  /// @param offset Their offset in the file; @param what What they are, such as "chunk": both for errors.
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
  /// Preceded by its length in four bytes.
  std::string_view text();
  /// @throws Failure if fewer are left.
  std::string_view raw(std::uint64_t size);
  std::string_view rest();
  /// @return A reader for the next bytes, which are skipped here.
  ByteReader part(std::uint64_t size);

  bool isAtEnd() const { return at_ == bytes_.size(); }
  /// Offset in the file.
  std::uint64_t offset() const { return offset_ + at_; }
  std::size_t position() const { return at_; }
  /// @throws Failure with the reader's position.
  [[noreturn]] void fail(const std::string& why) const;

 private:
  std::string_view bytes_;
  std::uint64_t offset_;
  std::string_view what_;
  std::size_t at_ = 0;
};

/// @return "byte 1234: WHY", printed in errors after the file's name.
std::string atByte(std::uint64_t offset, const std::string& why);

}  // namespace pongsim::log
