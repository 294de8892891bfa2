#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::cli {

/// A key as Fortress's key publisher names it: Qt's code, which is upper-case ASCII where there is such a letter.
struct Key {
  std::int32_t code = 0;
  std::string name;
  bool operator==(const Key&) const = default;
};

/// Makes keys of the bytes that a terminal sends for them (ECMA-48 5.4 and xterm's cursor keys).
class KeyReader {
 public:
  /// @return The keys that are complete with these bytes. What stands for no known key is left out.
  std::vector<Key> read(std::string_view bytes);

  /// @return Whether an escape has been read that may begin a sequence, or be the Escape key.
  bool isWaiting() const { return !sequence_.empty(); }

  /// Takes it that nothing follows that belongs to what was read.
  std::vector<Key> endSequence();

 private:
  void readByte(char byte, std::vector<Key>& keys);

  /// From the escape on.
  std::string sequence_;
};

}  // namespace pongsim::cli
