#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace pongsim::trust {

/// A rule of governance.p7s: how the participants of a domain protect what they send.
struct GovernanceRule {
  std::vector<std::pair<int, int>> domains;
};

/// @throws KeystoreError if it can't be read, or has no rules.
std::vector<GovernanceRule> readGovernance(const std::filesystem::path& file, const std::string& text);

/// @throws KeystoreError if no rule covers the domain.
void requireDomain(const std::filesystem::path& file, const std::vector<GovernanceRule>& rules, int domain);

}  // namespace pongsim::trust
