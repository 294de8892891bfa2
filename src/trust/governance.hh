#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace pongsim::trust {

/// What governance.p7s says of a domain: how participants protect what they send.
struct GovernanceRule {
  std::vector<std::pair<int, int>> domains;
};

/// @throws KeystoreError where it can't be read, or has no rules.
std::vector<GovernanceRule> readGovernance(const std::filesystem::path& file, const std::string& text);

/// @throws KeystoreError where no rule is of that domain.
void requireDomain(const std::filesystem::path& file, const std::vector<GovernanceRule>& rules, int domain);

}  // namespace pongsim::trust
