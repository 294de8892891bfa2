#include "trust/permissions.hh"

#include <fnmatch.h>

#include <algorithm>
#include <cstring>

#include "trust/certificate.hh"
#include "trust/xml_reader.hh"

namespace pongsim {

bool TopicRule::covers(int domain) const { return trust::cover(domains, domain); }

bool isPermitted(const SecureIdentity& identity, int domain, TopicUse use, std::string_view topic) {
  const std::string name(topic);
  for (const TopicRule& rule : identity.rules) {
    if (!rule.covers(domain)) continue;
    for (const std::string& pattern : use == TopicUse::kPublish ? rule.publish : rule.subscribe) {
      if (fnmatch(pattern.c_str(), name.c_str(), FNM_NOESCAPE) == 0) return rule.isAllowed;
    }
  }
  return false;
}

namespace trust {

namespace {

namespace fs = std::filesystem;
using tinyxml2::XMLElement;

/// A time as Fast DDS reads it: in this machine's time zone.
std::time_t timeIn(const fs::path& file, const XMLElement& element) {
  const std::string text = textOf(file, element);
  std::tm parts{};
  const char* end = strptime(text.c_str(), "%Y-%m-%dT%H:%M:%S", &parts);
  if (end == nullptr) refuse(file, element, "'" + text + "' is not a time like 2026-11-23T12:00:00");
  parts.tm_isdst = -1;
  return std::mktime(&parts);
}

void addTopics(const fs::path& file, const XMLElement& criteria, std::vector<std::string>& patterns) {
  for (auto* topics = criteria.FirstChildElement(); topics != nullptr; topics = topics->NextSiblingElement()) {
    const std::string_view name = topics->Name();
    if (name == "partitions" || name == "data_tags") continue;
    if (name != "topics") refuse(file, *topics, "<" + std::string(name) + "> is not <topics> or <partitions>");
    childOf(file, *topics, "topic");
    for (auto* topic = topics->FirstChildElement(); topic != nullptr; topic = topic->NextSiblingElement()) {
      if (std::strcmp(topic->Name(), "topic") != 0) {
        refuse(file, *topic, "<" + std::string(topic->Name()) + "> is not <topic>");
      }
      patterns.push_back(textOf(file, *topic));
    }
  }
}

TopicRule ruleIn(const fs::path& file, const XMLElement& element) {
  TopicRule rule;
  rule.isAllowed = std::strcmp(element.Name(), "allow_rule") == 0;
  const XMLElement* first = element.FirstChildElement();
  if (first == nullptr || std::strcmp(first->Name(), "domains") != 0) {
    refuse(file, element, "<" + std::string(element.Name()) + "> does not begin with <domains>");
  }
  rule.domains = domainsIn(file, *first);
  for (const XMLElement* each = first->NextSiblingElement(); each != nullptr; each = each->NextSiblingElement()) {
    const std::string_view name = each->Name();
    if (name == "publish") {
      addTopics(file, *each, rule.publish);
    } else if (name == "subscribe") {
      addTopics(file, *each, rule.subscribe);
    } else if (name != "relay") {
      refuse(file, *each, "<" + std::string(name) + "> is not <publish>, <subscribe> or <relay>");
    }
  }
  return rule;
}

/// @return Whether `wider` certainly matches everything that `pattern` matches. Found by matching `wider` against the
/// text of `pattern`; not if `wider` has a '?' or a set, which would match a '*' in that text.
bool isSurelyWider(const std::string& wider, const std::string& pattern) {
  if (wider == pattern) return true;
  return wider.find_first_of("?[]") == std::string::npos && fnmatch(wider.c_str(), pattern.c_str(), FNM_NOESCAPE) == 0;
}

/// Refuses a pattern that has no effect because an earlier rule of the opposite kind covers all of it.
void requireEffect(const fs::path& file, const XMLElement& element, const std::vector<TopicRule>& earlier,
                   const TopicRule& rule, std::vector<std::string> TopicRule::*use) {
  for (const TopicRule& other : earlier) {
    const auto overlaps = [&other](const std::pair<int, int>& range) {
      return std::ranges::any_of(other.domains, [&range](const std::pair<int, int>& each) {
        return each.first <= range.first && range.second <= each.second;
      });
    };
    if (other.isAllowed == rule.isAllowed || !std::ranges::all_of(rule.domains, overlaps)) continue;
    for (const std::string& pattern : rule.*use) {
      const auto covers = [&pattern](const std::string& wider) { return isSurelyWider(wider, pattern); };
      const auto wider = std::ranges::find_if(other.*use, covers);
      if (wider == (other.*use).end()) continue;
      refuse(file, element,
             "contradiction: topic '" + pattern + "' is " + (rule.isAllowed ? "allowed" : "denied") + " after '" +
                 *wider + "' has been " + (other.isAllowed ? "allowed" : "denied") + ", and the first rule counts");
    }
  }
}

std::vector<TopicRule> rulesIn(const fs::path& file, const XMLElement& grant, const XMLElement* first) {
  std::vector<TopicRule> rules;
  const XMLElement* each = first;
  for (; each != nullptr; each = each->NextSiblingElement()) {
    const std::string_view name = each->Name();
    if (name != "allow_rule" && name != "deny_rule") break;
    TopicRule rule = ruleIn(file, *each);
    requireEffect(file, *each, rules, rule, &TopicRule::publish);
    requireEffect(file, *each, rules, rule, &TopicRule::subscribe);
    rules.push_back(std::move(rule));
  }
  if (rules.empty()) refuse(file, grant, "<grant> has neither <allow_rule> nor <deny_rule> after <validity>");
  if (each == nullptr || std::strcmp(each->Name(), "default") != 0) {
    refuse(file, each == nullptr ? grant : *each, "<grant> does not end with <default>");
  }
  const std::string otherwise = textOf(file, *each);
  if (otherwise != "DENY") {
    refuse(file, *each,
           "<default> is '" + otherwise + "': only DENY is supported; write an <allow_rule> with '*' instead");
  }
  return rules;
}

Grant grantIn(const fs::path& file, const XMLElement& element) {
  if (element.Attribute("name") == nullptr) refuse(file, element, "<grant> has no name");
  const XMLElement* subject = element.FirstChildElement();
  if (subject == nullptr || std::strcmp(subject->Name(), "subject_name") != 0) {
    refuse(file, element, "<grant> does not begin with <subject_name>");
  }
  const XMLElement* validity = subject->NextSiblingElement();
  if (validity == nullptr || std::strcmp(validity->Name(), "validity") != 0) {
    refuse(file, *subject, "<subject_name> is not followed by <validity>");
  }
  Grant grant;
  grant.subject = textOf(file, *subject);
  grant.validFrom = timeIn(file, childOf(file, *validity, "not_before"));
  grant.validUntil = timeIn(file, childOf(file, *validity, "not_after"));
  if (grant.validUntil <= grant.validFrom) refuse(file, *validity, "<validity> ends before it begins");
  grant.rules = rulesIn(file, element, validity->NextSiblingElement());
  return grant;
}

/// @return The name without spaces after the commas between its parts.
std::string withoutBlanks(const std::string& name) {
  std::string result;
  for (const char each : name) {
    if (each != ' ' || (!result.empty() && result.back() != ',')) result += each;
  }
  return result;
}

}  // namespace

std::vector<Grant> readPermissions(const fs::path& file, const std::string& text) {
  tinyxml2::XMLDocument document;
  parseDocument(file, text, document);
  const XMLElement& permissions = childOf(file, *document.RootElement(), "permissions");
  childOf(file, permissions, "grant");
  std::vector<Grant> grants;
  for (auto* each = permissions.FirstChildElement(); each != nullptr; each = each->NextSiblingElement()) {
    if (std::strcmp(each->Name(), "grant") != 0)
      refuse(file, *each, "<" + std::string(each->Name()) + "> is not <grant>");
    grants.push_back(grantIn(file, *each));
  }
  return grants;
}

const Grant& grantOf(const fs::path& file, const std::vector<Grant>& grants, const std::string& subject) {
  const auto isOfSubject = [own = withoutBlanks(subject)](const Grant& grant) {
    return withoutBlanks(grant.subject) == own;
  };
  const auto found = std::ranges::find_if(grants, isOfSubject);
  if (found == grants.end()) {
    throw KeystoreError(file.string() + " grants nothing to " + subject + ", but to " + grants.front().subject,
                        "its <subject_name> must match the certificate's");
  }
  if (std::ranges::count_if(grants, isOfSubject) > 1) {
    throw KeystoreError(file.string() + " has several grants for " + subject + ", of which only one would apply");
  }
  return *found;
}

void requireUsable(const fs::path& file, const Grant& grant, int domain) {
  const std::time_t now = std::time(nullptr);
  if (grant.validUntil < now) throw KeystoreError(file.string() + " expired on " + dayOf(grant.validUntil));
  if (grant.validFrom > now) {
    throw KeystoreError(file.string() + " is not valid before " + dayOf(grant.validFrom),
                        "check this machine's clock: it says " + dayOf(now));
  }
  const bool isAllowed = std::ranges::any_of(
      grant.rules, [domain](const TopicRule& rule) { return rule.isAllowed && (domain < 0 || rule.covers(domain)); });
  if (isAllowed) return;
  throw KeystoreError(file.string() + " allows nothing" +
                      (domain < 0 ? std::string() : " in DDS domain " + std::to_string(domain)));
}

}  // namespace trust

}  // namespace pongsim
