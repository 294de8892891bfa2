#include <algorithm>
#include <filesystem>

#include "pongsim/program/keystore.hh"
#include "trust/certificate.hh"
#include "trust/governance.hh"
#include "trust/keystore.hh"
#include "trust/permissions.hh"
#include "trust/signed_text.hh"

namespace pongsim {

namespace {

namespace fs = std::filesystem;

// SROS 2's names of an identity's files.
constexpr const char* kIdentityAuthority = "identity_ca.cert.pem";
constexpr const char* kCertificate = "cert.pem";
constexpr const char* kKey = "key.pem";
constexpr const char* kPermissionsAuthority = "permissions_ca.cert.pem";
constexpr const char* kGovernance = "governance.p7s";
constexpr const char* kPermissions = "permissions.p7s";
constexpr const char* kRevoked = "crl.pem";

/// Reads and checks the certificate and its key.
void readCertificates(const fs::path& folder, SecureIdentity& identity) {
  const trust::Certificate authority = trust::readCertificate(folder / kIdentityAuthority);
  const trust::Certificate certificate = trust::readCertificate(folder / kCertificate);
  const auto key = trust::readKey(folder / kKey);
  trust::requireValidNow(authority);
  trust::requireValidNow(certificate);
  trust::requireIssuedBy(certificate, authority);
  trust::requireKeyOf(certificate, *key, folder / kKey);
  identity.subject = certificate.subject();
  identity.validFrom = std::max(authority.validFrom(), certificate.validFrom());
  identity.validUntil = std::min(authority.validUntil(), certificate.validUntil());
}

/// Reads and checks the signed documents: governance and permissions.
void readDocuments(const fs::path& folder, std::optional<int> domain, SecureIdentity& identity) {
  const trust::Certificate authority = trust::readCertificate(folder / kPermissionsAuthority);
  trust::requireValidNow(authority);
  const fs::path governance = folder / kGovernance;
  const auto rules = trust::readGovernance(governance, trust::signedText(governance, authority));
  if (domain) trust::requireDomain(governance, rules, *domain);

  const fs::path permissions = folder / kPermissions;
  const auto grants = trust::readPermissions(permissions, trust::signedText(permissions, authority));
  const trust::Grant& grant = trust::grantOf(permissions, grants, identity.subject);
  trust::requireUsable(permissions, grant, domain.value_or(-1));
  identity.validFrom = std::max({identity.validFrom, authority.validFrom(), grant.validFrom});
  identity.validUntil = std::min({identity.validUntil, authority.validUntil(), grant.validUntil});
  identity.rules = grant.rules;
}

}  // namespace

SecureIdentity readIdentity(const std::string& folder, std::optional<int> domain) {
  SecureIdentity identity;
  std::error_code error;
  const fs::path real = fs::canonical(folder, error);
  if (error) throw KeystoreError("there is no folder '" + folder + "'");
  identity.folder = real.string();
  identity.name = trust::nameOf(real);
  readCertificates(folder, identity);
  readDocuments(folder, domain, identity);
  return identity;
}

void checkPermissions(const std::string& file, const std::string& text, const std::string& subject) {
  trust::requireUsable(file, trust::grantOf(file, trust::readPermissions(file, text), subject), -1);
}

std::vector<std::pair<std::string, std::string>> securityProperties(const SecureIdentity& identity) {
  const std::string identityPrefix = "dds.sec.auth.builtin.PKI-DH.";
  const std::string accessPrefix = "dds.sec.access.builtin.Access-Permissions.";
  const auto file = [&](const char* name) { return "file://" + (fs::path(identity.folder) / name).string(); };
  std::vector<std::pair<std::string, std::string>> properties = {
      {"dds.sec.auth.plugin", "builtin.PKI-DH"},
      {identityPrefix + "identity_ca", file(kIdentityAuthority)},
      {identityPrefix + "identity_certificate", file(kCertificate)},
      {identityPrefix + "private_key", file(kKey)},
      {"dds.sec.crypto.plugin", "builtin.AES-GCM-GMAC"},
      {"dds.sec.access.plugin", "builtin.Access-Permissions"},
      {accessPrefix + "permissions_ca", file(kPermissionsAuthority)},
      {accessPrefix + "governance", file(kGovernance)},
      {accessPrefix + "permissions", file(kPermissions)}};
  std::error_code error;
  if (fs::is_regular_file(fs::path(identity.folder) / kRevoked, error)) {
    properties.emplace_back(identityPrefix + "identity_crl", file(kRevoked));
  }
  return properties;
}

}  // namespace pongsim
