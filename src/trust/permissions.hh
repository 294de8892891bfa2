#pragma once

#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "pongsim/program/keystore.hh"

namespace pongsim::trust {

/// A `<grant>` of the permissions.
struct Grant {
  std::string subject;
  std::time_t validFrom = 0;
  std::time_t validUntil = 0;
  std::vector<TopicRule> rules;
};

/// @throws KeystoreError if they can't be read, or if a rule has no effect because an earlier one says the opposite.
std::vector<Grant> readPermissions(const std::filesystem::path& file, const std::string& text);

/// @return The grant for the subject.
/// @throws KeystoreError if there is none, or more than one.
const Grant& grantOf(const std::filesystem::path& file, const std::vector<Grant>& grants, const std::string& subject);

/// @throws KeystoreError if the grant is not valid now, or allows nothing in that domain (negative: in any).
void requireUsable(const std::filesystem::path& file, const Grant& grant, int domain);

}  // namespace pongsim::trust
