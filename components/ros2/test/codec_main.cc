// For test_codec.py. Reads lines "TYPE HEX" with a payload of that type, decodes it and prints it encoded again. For a
// line "TYPE" it prints the type's hash, for "TYPE definition" its definition with '|' for line breaks.
#include <algorithm>
#include <charconv>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "ros2/test/all_types.hh"
#include "ros2/types/cdr.hh"
#include "ros2/types/message_definition.hh"
#include "ros2/types/type_hash.hh"

namespace pongsim::ros2 {
namespace {

using Bytes = std::vector<std::byte>;

Bytes fromHex(const std::string& text) {
  Bytes bytes(text.size() / 2);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    unsigned value = 0;
    std::from_chars(&text[2 * i], &text[2 * i] + 2, value, 16);
    bytes[i] = static_cast<std::byte>(value);
  }
  return bytes;
}

std::string toHex(const Bytes& bytes) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const std::byte byte : bytes) {
    text += kDigits[static_cast<unsigned>(byte) >> 4];
    text += kDigits[static_cast<unsigned>(byte) & 15];
  }
  return text;
}

struct Codec {
  std::function<std::string(const Bytes&)> again;
  std::function<std::string()> hash;
  std::function<std::string()> definition;
};

template <class Type>
std::string again(const Bytes& payload) {
  Type value;
  if (const auto error = readCdr(payload, value)) return "error: " + *error;
  const Bytes written = toCdr(value);
  return written.size() == cdrSize(value) ? toHex(written) : "error: of another size than was said";
}

int run() {
  std::map<std::string, Codec> codecs;
  forAllTypes([&codecs]<class Type>() {
    codecs[nameOf<Type>()] = {again<Type>, typeHash<Type>, messageDefinition<Type>};
  });
  for (std::string type, rest; std::cin >> type;) {
    std::getline(std::cin, rest);
    const auto codec = codecs.find(type);
    if (codec == codecs.end()) {
      std::cout << "error: no such type" << std::endl;
    } else if (rest.empty()) {
      std::cout << codec->second.hash() << std::endl;
    } else if (rest == " definition") {
      std::string text = codec->second.definition();
      std::ranges::replace(text, '\n', '|');
      std::cout << text << std::endl;
    } else {
      std::cout << codec->second.again(fromHex(rest.substr(1))) << std::endl;
    }
  }
  return 0;
}

}  // namespace
}  // namespace pongsim::ros2

int main() { return pongsim::ros2::run(); }
