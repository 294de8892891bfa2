#include "cli/key/key_reader.hh"

#include <array>

namespace pongsim::cli {

namespace {

constexpr char kEscape = '\x1b';
constexpr std::size_t kLongestSequence = 16;

const Key kEscapeKey{16777216, "escape"};

/// Looks up the last character of the sequence.
Key arrow(char letter) {
  switch (letter) {
    case 'A':
      return {16777235, "up"};
    case 'B':
      return {16777237, "down"};
    case 'C':
      return {16777236, "right"};
    case 'D':
      return {16777234, "left"};
    default:
      return {};
  }
}

/// @return The key of a single byte; code 0 if there is none.
Key plainKey(char byte) {
  switch (byte) {
    case '\r':
    case '\n':
      return {16777220, "enter"};
    case '\t':
      return {16777217, "tab"};
    case '\b':
    case '\x7f':
      return {16777219, "backspace"};
    case ' ':
      return {32, "space"};
    default:
      break;
  }
  if (byte >= 'a' && byte <= 'z') byte = static_cast<char>(byte - 'a' + 'A');
  if (byte > ' ' && byte < '\x7f') return {byte, std::string(1, byte)};
  return {};
}

bool endsControlSequence(char byte) { return byte >= '@' && byte <= '~'; }

}  // namespace

std::vector<Key> KeyReader::read(std::string_view bytes) {
  std::vector<Key> keys;
  for (const char byte : bytes) readByte(byte, keys);
  return keys;
}

void KeyReader::readByte(char byte, std::vector<Key>& keys) {
  const auto add = [&keys](Key key) {
    if (key.code != 0) keys.push_back(std::move(key));
  };
  if (byte == kEscape) {
    // two in a row: the first one was the key
    if (sequence_.size() == 1) add(kEscapeKey);
    sequence_ = byte;
  } else if (sequence_.empty()) {
    add(plainKey(byte));
  } else if (sequence_.size() == 1) {
    if (byte == '[' || byte == 'O') {
      sequence_ += byte;
    } else {
      sequence_.clear();
      add(kEscapeKey);
      add(plainKey(byte));
    }
  } else if (endsControlSequence(byte) || sequence_.size() >= kLongestSequence) {
    sequence_.clear();
    add(arrow(byte));
  } else {
    sequence_ += byte;
  }
}

std::vector<Key> KeyReader::endSequence() {
  const bool isEscape = sequence_.size() == 1;
  sequence_.clear();
  return isEscape ? std::vector<Key>{kEscapeKey} : std::vector<Key>{};
}

}  // namespace pongsim::cli
