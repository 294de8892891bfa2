#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::cli {

/// A key, numbered as by Fortress's key publisher: Qt's code, which is upper-case ASCII where such a character exists.
struct Key {
  std::int32_t code = 0;
  std::string name;
  bool operator==(const Key&) const = default;
};

/// Decodes the bytes that a terminal sends for keys (ECMA-48 5.4 and xterm's cursor keys).
class KeyReader {
 public:
  /// @return The keys completed by these bytes. Unknown sequences are ignored.
  std::vector<Key> read(std::string_view bytes);

  /// @return Whether an escape was read that may begin a sequence, or be the Escape key.
  bool isWaiting() const { return !sequence_.empty(); }

  /// Call if no more bytes follow: decodes what was read so far.
  std::vector<Key> endSequence();

 private:
  void readByte(char byte, std::vector<Key>& keys);

  /// Starts with the escape.
  std::string sequence_;
};

}  // namespace pongsim::cli
