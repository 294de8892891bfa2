#include "web/typed/asset_address.hh"

#include <cctype>
#include <charconv>

namespace pongsim::web::typed {

namespace {

constexpr std::string_view kPackage = "package://pongsim/";
constexpr std::string_view kFile = "file";
constexpr std::string_view kScheme = "://";

std::string percentDecoded(std::string_view text) {
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

std::string percentEncoded(std::string_view text, std::string_view more) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string all;
  for (const char letter : text) {
    const auto c = static_cast<unsigned char>(letter);
    if (std::isalnum(c) != 0 || std::string_view("-._~").find(letter) != std::string_view::npos ||
        more.find(letter) != std::string_view::npos) {
      all += letter;
    } else {
      all += {'%', kDigits[c >> 4U], kDigits[c & 15U]};
    }
  }
  return all;
}

std::string packageAddress(std::string_view address) {
  std::string_view scheme = kFile;
  std::string_view rest = address;
  if (const std::size_t colon = address.find(kScheme); colon != std::string_view::npos) {
    scheme = address.substr(0, colon);
    rest = address.substr(colon + kScheme.size());
  }
  while (scheme == kFile && rest.starts_with('/')) rest.remove_prefix(1);
  return std::string(kPackage) + percentEncoded(scheme, "/") + "/" + percentEncoded(rest, "/");
}

std::string sceneAddress(std::string_view address) {
  if (!address.starts_with(kPackage)) return std::string(address);
  const std::string plain = percentDecoded(address.substr(kPackage.size()));
  const std::size_t slash = plain.find('/');
  if (slash == std::string::npos) return std::string(address);
  const std::string scheme = plain.substr(0, slash);
  if (scheme == kFile) return plain.substr(slash);
  return scheme + std::string(kScheme) + plain.substr(slash + 1);
}

}  // namespace pongsim::web::typed
