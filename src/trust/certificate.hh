#pragma once

#include <ctime>
#include <filesystem>
#include <string>

#include "trust/openssl.hh"

namespace pongsim::trust {

/// A certificate of X.509, and the file it stands in.
struct Certificate {
  std::filesystem::path file;
  Owned<X509> x509;

  /// As RFC 2253 writes it.
  std::string subject() const;
  std::time_t validFrom() const;
  std::time_t validUntil() const;
};

/// @throws KeystoreError
Certificate readCertificate(const std::filesystem::path& file);

/// @throws KeystoreError where it is none without a password, or others can read it.
Owned<EVP_PKEY> readKey(const std::filesystem::path& file);

/// @throws KeystoreError where the certificate is not valid now.
void requireValidNow(const Certificate& certificate);

/// @throws KeystoreError where `authority` has not issued the certificate, or may not.
void requireIssuedBy(const Certificate& certificate, const Certificate& authority);

/// @throws KeystoreError where the key is not that of the certificate.
void requireKeyOf(const Certificate& certificate, EVP_PKEY& key, const std::filesystem::path& keyFile);

/// @return A day, "2026-11-23", by UTC.
std::string dayOf(std::time_t time);

}  // namespace pongsim::trust
