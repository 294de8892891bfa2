#pragma once

#include <openssl/evp.h>
#include <openssl/x509.h>

#include <ctime>
#include <filesystem>
#include <memory>
#include <string>

namespace pongsim::security {

struct Free {
  void operator()(EVP_PKEY* key) const { EVP_PKEY_free(key); }
  void operator()(X509* certificate) const { X509_free(certificate); }
};

/// A private key and the certificate of its owner.
struct Credentials {
  std::unique_ptr<EVP_PKEY, Free> key;
  std::unique_ptr<X509, Free> certificate;

  std::time_t validFrom() const;
  std::time_t validUntil() const;
  std::string keyAsPem() const;
  std::string certificateAsPem() const;
};

/// Creates a certificate authority: EC on P-256, self-signed with SHA-256.
/// @throws cli::Failure
Credentials makeAuthority(int days);

/// Creates credentials of a participant with subject "CN=/robot", signed by the authority. They are valid from one day
/// ago for this many days, but not longer than the authority. The day covers differences between clocks, and between
/// time zones: Fast DDS reads the times in permissions as local time.
/// @throws cli::Failure
Credentials makeIdentity(const std::string& name, int days, const Credentials& authority);

/// @throws KeystoreError if a file is missing, unreadable or not PEM, or if the key can be read by others or does not
/// match the certificate.
Credentials readCredentials(const std::filesystem::path& certificate, const std::filesystem::path& key);

/// @return The text as an S/MIME message with a detached signature (multipart/signed), as DDS-Security requires.
/// @throws cli::Failure
std::string signedBy(const Credentials& authority, const std::string& text);

}  // namespace pongsim::security
