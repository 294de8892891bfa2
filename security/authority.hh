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

/// A private key, and the certificate that says whose it is.
struct Credentials {
  std::unique_ptr<EVP_PKEY, Free> key;
  std::unique_ptr<X509, Free> certificate;

  std::time_t validFrom() const;
  std::time_t validUntil() const;
  std::string keyAsPem() const;
  std::string certificateAsPem() const;
};

/// A new certificate authority: EC on P-256, signed by itself with SHA-256.
/// @throws programs::Failure
Credentials makeAuthority(int days);

/// New credentials of a participant, "CN=/robot", that the authority signs, valid from a day ago for so many days, and
/// no longer than the authority. That day is for clocks that differ, and for Fast DDS, which reads the times of
/// permissions by the local time zone.
/// @throws programs::Failure
Credentials makeIdentity(const std::string& name, int days, const Credentials& authority);

/// @throws KeystoreError where one of the files is missing, unreadable or no PEM, the key can be read by others or is
/// not that of the certificate.
Credentials readCredentials(const std::filesystem::path& certificate, const std::filesystem::path& key);

/// @return The text, signed by S/MIME as DDS-Security wants it: legible, with the signature behind it.
/// @throws programs::Failure
std::string signedBy(const Credentials& authority, const std::string& text);

}  // namespace pongsim::security
