#include "trust/xml_reader.hh"

#include <algorithm>
#include <cstring>
#include <optional>

#include "base/parse_number.hh"

namespace pongsim::trust {

namespace {

constexpr int kLastDomain = 232;

int domainIn(const std::filesystem::path& file, const tinyxml2::XMLElement& element) {
  const std::string text = textOf(file, element);
  const std::optional<long long> number = base::parseInteger(text);
  if (!number || *number < 0) refuse(file, element, "'" + text + "' is not a DDS domain");
  return static_cast<int>(std::min<long long>(*number, kLastDomain));
}

}  // namespace

std::string textOf(const std::filesystem::path& file, const tinyxml2::XMLElement& element) {
  constexpr const char* kBlank = " \t\r\n";
  const std::string text = element.GetText() == nullptr ? "" : element.GetText();
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string::npos) refuse(file, element, "<" + std::string(element.Name()) + "> is empty");
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::vector<std::pair<int, int>> domainsIn(const std::filesystem::path& file, const tinyxml2::XMLElement& domains) {
  std::vector<std::pair<int, int>> all;
  for (auto* each = domains.FirstChildElement(); each != nullptr; each = each->NextSiblingElement()) {
    if (std::strcmp(each->Name(), "id") == 0) {
      const int domain = domainIn(file, *each);
      all.emplace_back(domain, domain);
    } else if (std::strcmp(each->Name(), "id_range") == 0) {
      // either end may be left open
      const tinyxml2::XMLElement* first = each->FirstChildElement("min");
      const tinyxml2::XMLElement* last = each->FirstChildElement("max");
      all.emplace_back(first == nullptr ? 0 : domainIn(file, *first),
                       last == nullptr ? kLastDomain : domainIn(file, *last));
    } else {
      refuse(file, *each, "<" + std::string(each->Name()) + "> is neither <id> nor <id_range>");
    }
  }
  if (all.empty()) refuse(file, domains, "<domains> is empty");
  return all;
}

bool cover(const std::vector<std::pair<int, int>>& domains, int domain) {
  return std::ranges::any_of(domains,
                             [domain](const auto& range) { return range.first <= domain && domain <= range.second; });
}

void parseDocument(const std::filesystem::path& file, const std::string& text, tinyxml2::XMLDocument& document) {
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    throw KeystoreError(file.string() + ":" + std::to_string(document.ErrorLineNum()) + ": the XML is malformed");
  }
  const tinyxml2::XMLElement* root = document.RootElement();
  if (root == nullptr || std::strcmp(root->Name(), "dds") != 0) {
    throw KeystoreError(file.string() + ": its outermost element is not <dds>");
  }
}

}  // namespace pongsim::trust
