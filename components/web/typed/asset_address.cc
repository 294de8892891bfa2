#include "web/typed/asset_address.hh"

#include <charconv>

namespace pongsim::web::typed {

namespace {

constexpr std::string_view kPackage = "package://pongsim/";
constexpr std::string_view kFile = "file";
constexpr std::string_view kScheme = "://";

bool isPlain(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') ||
         std::string_view("-._~/").find(letter) != std::string_view::npos;
}

std::string escaped(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string all;
  for (const char letter : text) {
    if (isPlain(letter)) {
      all += letter;
      continue;
    }
    const auto byte = static_cast<unsigned char>(letter);
    all += '%';
    all += kDigits[byte >> 4];
    all += kDigits[byte & 15];
  }
  return all;
}

std::string unescaped(std::string_view text) {
  std::string all;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned byte = 0;
    const char* const digits = text.data() + i + 1;
    if (text[i] == '%' && i + 2 < text.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
      all += static_cast<char>(byte);
      i += 2;
    } else {
      all += text[i];
    }
  }
  return all;
}

}  // namespace

std::string packageAddress(std::string_view address) {
  std::string_view scheme = kFile;
  std::string_view rest = address;
  if (const std::size_t colon = address.find(kScheme); colon != std::string_view::npos) {
    scheme = address.substr(0, colon);
    rest = address.substr(colon + kScheme.size());
  }
  while (scheme == kFile && rest.starts_with('/')) rest.remove_prefix(1);
  return std::string(kPackage) + escaped(scheme) + "/" + escaped(rest);
}

std::string sceneAddress(std::string_view address) {
  if (!address.starts_with(kPackage)) return std::string(address);
  const std::string plain = unescaped(address.substr(kPackage.size()));
  const std::size_t slash = plain.find('/');
  if (slash == std::string::npos) return std::string(address);
  const std::string scheme = plain.substr(0, slash);
  if (scheme == kFile) return plain.substr(slash);
  return scheme + std::string(kScheme) + plain.substr(slash + 1);
}

}  // namespace pongsim::web::typed
