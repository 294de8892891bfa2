#include "fuel/sdf_text.hh"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

namespace pongsim::fuel {

namespace {

constexpr std::array<std::pair<std::string_view, char>, 5> kEntities{
    {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}}};
constexpr std::string_view kSpace = " \t\r\n";

std::string decoded(std::string_view text) {
  std::string plain;
  while (!text.empty()) {
    const auto entity = std::ranges::find_if(kEntities, [&](const auto& each) { return text.starts_with(each.first); });
    const bool isEntity = entity != kEntities.end();
    plain += isEntity ? entity->second : text.front();
    text.remove_prefix(isEntity ? entity->first.size() : 1);
  }
  return plain;
}

std::string lowerCase(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char each) {
    return each < 0x80 ? static_cast<char>(std::tolower(each)) : static_cast<char>(each);
  });
  return text;
}

/// Reads a file tag by tag, and collects the texts of elements without child elements.
class XmlWalk {
 public:
  explicit XmlWalk(std::string_view file) : file_(file) {}

  std::vector<XmlText> texts() {
    while ((at_ = file_.find('<', at_)) != file_.npos && tag()) {
    }
    return std::move(texts_);
  }

 private:
  /// Moves behind the next `end`.
  /// @return Whether there is one.
  bool pass(std::string_view end) {
    const std::size_t found = file_.find(end, at_);
    at_ = found + end.size();
    textStart_.reset();
    return found != file_.npos;
  }

  /// @return The position of the ">" that ends the tag at `at_`; one in an attribute's value does not count.
  std::size_t endOfTag() const {
    char quote = 0;
    for (std::size_t i = at_; i < file_.size(); ++i) {
      if (quote != 0) {
        if (file_[i] == quote) quote = 0;
      } else if (file_[i] == '"' || file_[i] == '\'') {
        quote = file_[i];
      } else if (file_[i] == '>') {
        return i;
      }
    }
    return file_.npos;
  }

  bool tag() {
    const std::string_view rest = file_.substr(at_);
    if (rest.starts_with("<!--")) return pass("-->");
    if (rest.starts_with("<![CDATA[")) return pass("]]>");
    if (rest.starts_with("<?")) return pass("?>");
    const std::size_t end = endOfTag();
    if (end == file_.npos) return false;
    const std::string_view inside = file_.substr(at_ + 1, end - at_ - 1);
    const std::string_view name = inside.substr(0, inside.find_first_of(" \t\r\n/", 1));
    if (inside.starts_with('/')) {
      close();
    } else if (!inside.starts_with('!') && !inside.ends_with('/')) {
      lengths_.push_back(path_.size());
      path_ += "/" + std::string(name);
      textStart_ = end + 1;
      at_ = end + 1;
      return lengths_.size() < 1000;
    } else {
      textStart_.reset();
    }
    at_ = end + 1;
    return true;
  }

  /// Handles the end of an element: adds its text if it has no child elements.
  void close() {
    if (lengths_.empty()) return;
    if (textStart_) {
      const std::string_view text = file_.substr(*textStart_, at_ - *textStart_);
      const std::size_t first = text.find_first_not_of(kSpace);
      if (first != text.npos) {
        const std::size_t last = text.find_last_not_of(kSpace) + 1;
        texts_.push_back({path_, decoded(text.substr(first, last - first)), *textStart_ + first, *textStart_ + last});
      }
    }
    path_.resize(lengths_.back());
    lengths_.pop_back();
    textStart_.reset();
  }

  std::string_view file_;
  std::size_t at_ = 0;
  std::string path_;
  std::vector<std::size_t> lengths_;
  std::optional<std::size_t> textStart_;
  std::vector<XmlText> texts_;
};

/// @return Whether Fortress replaces "model://" addresses in the element with this path.
bool isReplaced(const std::string& path) {
  constexpr std::array<std::string_view, 4> kPlaces{"/mesh/uri", "/material/script/uri", "/skin/filename",
                                                    "/animation/filename"};
  const auto endsThere = [&](std::string_view place) { return path.ends_with(place); };
  if (std::ranges::any_of(kPlaces, endsThere)) return true;
  const bool isMap = path.ends_with("_map");
  return isMap && (path.find("/pbr/metal/") != std::string::npos || path.find("/pbr/specular/") != std::string::npos);
}

}  // namespace

std::vector<XmlText> xmlTexts(std::string_view file) { return XmlWalk(file).texts(); }

std::vector<std::string> fuelAddressesInXml(std::string_view file) {
  std::vector<std::string> addresses;
  for (const XmlText& each : xmlTexts(file)) {
    if (parseFuelAddress(each.text)) addresses.push_back(each.text);
  }
  return addresses;
}

std::vector<std::string> fuelAddressesInQuotes(std::string_view file) {
  std::vector<std::string> addresses;
  for (std::size_t start = file.find('"'); start != file.npos;) {
    const std::size_t end = file.find('"', start + 1);
    if (end == file.npos) break;
    const std::string text(file.substr(start + 1, end - start - 1));
    if (parseFuelAddress(text)) addresses.push_back(text);
    start = file.find('"', end + 1);
  }
  return addresses;
}

std::string modelFile(const XmlText& text) {
  constexpr std::string_view kScheme = "model://";
  if (!text.text.starts_with(kScheme) || !isReplaced(text.path)) return {};
  const std::size_t slash = text.text.find('/', kScheme.size());
  return slash == std::string::npos ? "" : text.text.substr(slash + 1);
}

std::string xmlAddress(const FuelAddress& address, const std::string& file) {
  const std::string plain = address.scheme + "://" + address.host + "/" + address.apiVersion + "/" +
                            lowerCase(address.owner) + (address.isWorld ? "/worlds/" : "/models/") +
                            lowerCase(address.name) + "/" + std::to_string(address.version.value_or(1)) + "/files/" +
                            file;
  std::string safe;
  for (const char each : plain) {
    const auto entity = std::ranges::find(kEntities, each, &std::pair<std::string_view, char>::second);
    const bool isSpecial = entity != kEntities.end() && each != '"' && each != '\'';
    safe += isSpecial ? std::string(entity->first) : std::string(1, each);
  }
  return safe;
}

}  // namespace pongsim::fuel
