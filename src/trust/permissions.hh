#pragma once

#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "pongsim/program/keystore.hh"

namespace pongsim::trust {

/// What a `<grant>` of permissions says.
struct Grant {
  std::string subject;
  std::time_t validFrom = 0;
  std::time_t validUntil = 0;
  std::vector<TopicRule> rules;
};

/// @throws KeystoreError where they can't be read, or a rule can never count since an earlier one says the opposite.
std::vector<Grant> readPermissions(const std::filesystem::path& file, const std::string& text);

/// @return The grant that is for the subject.
/// @throws KeystoreError where there is none, or several are.
const Grant& grantOf(const std::filesystem::path& file, const std::vector<Grant>& grants, const std::string& subject);

/// @throws KeystoreError where the grant is not valid now, or allows nothing in that domain (negative: in any).
void requireUsable(const std::filesystem::path& file, const Grant& grant, int domain);

}  // namespace pongsim::trust
