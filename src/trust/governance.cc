#include "trust/governance.hh"

#include <algorithm>
#include <cstring>

#include "trust/xml_reader.hh"

namespace pongsim::trust {

namespace {

constexpr const char* kKinds[] = {"NONE", "SIGN", "ENCRYPT", "SIGN_WITH_ORIGIN_AUTHENTICATION",
                                  "ENCRYPT_WITH_ORIGIN_AUTHENTICATION"};

void requireKind(const std::filesystem::path& file, const tinyxml2::XMLElement& rule, const char* name) {
  const tinyxml2::XMLElement& element = childOf(file, rule, name);
  const std::string kind = textOf(file, element);
  if (std::ranges::find(kKinds, kind) == std::end(kKinds)) {
    refuse(file, element, "'" + kind + "' is not a kind of protection: use NONE, SIGN or ENCRYPT");
  }
}

void requireTopicRules(const std::filesystem::path& file, const tinyxml2::XMLElement& rule) {
  const tinyxml2::XMLElement& rules = childOf(file, rule, "topic_access_rules");
  const tinyxml2::XMLElement* each = &childOf(file, rules, "topic_rule");
  for (; each != nullptr; each = each->NextSiblingElement("topic_rule")) {
    textOf(file, childOf(file, *each, "topic_expression"));
    for (const char* kind : {"metadata_protection_kind", "data_protection_kind"}) requireKind(file, *each, kind);
  }
}

}  // namespace

std::vector<GovernanceRule> readGovernance(const std::filesystem::path& file, const std::string& text) {
  tinyxml2::XMLDocument document;
  parseDocument(file, text, document);
  const tinyxml2::XMLElement& rules = childOf(file, *document.RootElement(), "domain_access_rules");
  std::vector<GovernanceRule> all;
  const tinyxml2::XMLElement* each = &childOf(file, rules, "domain_rule");
  for (; each != nullptr; each = each->NextSiblingElement("domain_rule")) {
    all.push_back({domainsIn(file, childOf(file, *each, "domains"))});
    for (const char* kind : {"discovery_protection_kind", "liveliness_protection_kind", "rtps_protection_kind"}) {
      requireKind(file, *each, kind);
    }
    requireTopicRules(file, *each);
  }
  return all;
}

void requireDomain(const std::filesystem::path& file, const std::vector<GovernanceRule>& rules, int domain) {
  if (std::ranges::any_of(rules, [domain](const auto& rule) { return cover(rule.domains, domain); })) return;
  throw KeystoreError(
      file.string() + " has no rule for DDS domain " + std::to_string(domain),
      "use one of its domains, or a keystore made with 'pongsim security init', which covers all domains");
}

}  // namespace pongsim::trust
