#pragma once

#include <ctime>
#include <filesystem>
#include <string>

#include "trust/openssl.hh"

namespace pongsim::trust {

/// An X.509 certificate and its file.
struct Certificate {
  std::filesystem::path file;
  Owned<X509> x509;

  /// In the format of RFC 2253.
  std::string subject() const;
  std::time_t validFrom() const;
  std::time_t validUntil() const;
};

/// @throws KeystoreError
Certificate readCertificate(const std::filesystem::path& file);

/// @throws KeystoreError if it is not a key without a password, or if others can read it.
Owned<EVP_PKEY> readKey(const std::filesystem::path& file);

/// @throws KeystoreError if the certificate is not valid now.
void requireValidNow(const Certificate& certificate);

/// @throws KeystoreError if `authority` has not issued the certificate, or is not allowed to.
void requireIssuedBy(const Certificate& certificate, const Certificate& authority);

/// @throws KeystoreError if the key does not belong to the certificate.
void requireKeyOf(const Certificate& certificate, EVP_PKEY& key, const std::filesystem::path& keyFile);

/// @return A date in UTC, "2026-11-23".
std::string dayOf(std::time_t time);

}  // namespace pongsim::trust
