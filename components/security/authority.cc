#include "security/authority.hh"

#include <openssl/bio.h>
#include <openssl/bn.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/pkcs7.h>
#include <openssl/x509v3.h>

#include <algorithm>
#include <cstdint>

#include "pongsim/program/keystore.hh"
#include "shared/program/failure.hh"

namespace pongsim::security {

namespace {

constexpr std::time_t kDay = 24 * 60 * 60;

struct FreeMore {
  void operator()(BIO* bio) const { BIO_free_all(bio); }
  void operator()(BIGNUM* number) const { BN_free(number); }
  void operator()(PKCS7* signature) const { PKCS7_free(signature); }
  void operator()(X509_EXTENSION* extension) const { X509_EXTENSION_free(extension); }
};
template <class T>
using Owned = std::unique_ptr<T, FreeMore>;

/// @throws cli::Failure if OpenSSL failed.
void require(bool isDone, const std::string& what) {
  if (isDone) return;
  char reason[256];
  ERR_error_string_n(ERR_get_error(), reason, sizeof reason);
  throw cli::Failure("OpenSSL can't " + what + ": " + reason);
}

std::string textIn(BIO& bio) {
  char* data = nullptr;
  const long size = BIO_get_mem_data(&bio, &data);
  return size > 0 ? std::string(data, static_cast<std::size_t>(size)) : std::string();
}

Owned<BIO> readable(const std::string& text) {
  return Owned<BIO>(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
}

/// Sets a random serial number: 127 bits, positive, and at most 20 octets as RFC 5280 (4.1.2.2) requires.
void setSerialNumber(X509& certificate) {
  constexpr int kBits = 127;
  const Owned<BIGNUM> number(BN_new());
  require(BN_rand(number.get(), kBits, BN_RAND_TOP_ONE, BN_RAND_BOTTOM_ANY) == 1 &&
              BN_to_ASN1_INTEGER(number.get(), X509_get_serialNumber(&certificate)) != nullptr,
          "make a serial number");
}

void setName(X509& certificate, const std::string& name) {
  require(X509_NAME_add_entry_by_txt(X509_get_subject_name(&certificate), "CN", MBSTRING_UTF8,
                                     reinterpret_cast<const unsigned char*>(name.data()), static_cast<int>(name.size()),
                                     -1, 0) == 1,
          "take the name '" + name + "'");
}

void addExtension(X509& certificate, X509& issuer, int kind, const char* value) {
  X509V3_CTX context;
  X509V3_set_ctx(&context, &issuer, &certificate, nullptr, nullptr, 0);
  const Owned<X509_EXTENSION> extension(X509V3_EXT_conf_nid(nullptr, &context, kind, value));
  require(extension && X509_add_ext(&certificate, extension.get(), -1) == 1, "add an extension to a certificate");
}

/// @return A new key pair, and a certificate for it that is not yet signed.
Credentials draft(const std::string& name, std::time_t from, std::time_t until) {
  Credentials made{std::unique_ptr<EVP_PKEY, Free>(EVP_EC_gen("P-256")), std::unique_ptr<X509, Free>(X509_new())};
  require(made.key && made.certificate, "make a key");
  X509& certificate = *made.certificate;
  require(X509_set_version(&certificate, X509_VERSION_3) == 1 && X509_set_pubkey(&certificate, made.key.get()) == 1 &&
              ASN1_TIME_set(X509_getm_notBefore(&certificate), from) != nullptr &&
              ASN1_TIME_set(X509_getm_notAfter(&certificate), until) != nullptr,
          "make a certificate");
  setSerialNumber(certificate);
  setName(certificate, name);
  return made;
}

std::time_t timeOf(const ASN1_TIME* time) {
  std::tm parts{};
  return ASN1_TIME_to_tm(time, &parts) == 1 ? timegm(&parts) : 0;
}

/// @return Eight random digits, to tell the names of several authorities apart in messages.
std::string mark() {
  const Owned<BIGNUM> number(BN_new());
  require(BN_rand(number.get(), 32, BN_RAND_TOP_ONE, BN_RAND_BOTTOM_ANY) == 1, "make a random number");
  char* digits = BN_bn2hex(number.get());
  std::string text = digits;
  OPENSSL_free(digits);
  std::ranges::transform(text, text.begin(),
                         [](char each) { return each >= 'A' ? static_cast<char>(each + 32) : each; });
  return text;
}

int noPassword(char*, int, int, void*) { return -1; }

}  // namespace

std::time_t Credentials::validFrom() const { return timeOf(X509_get0_notBefore(certificate.get())); }

std::time_t Credentials::validUntil() const { return timeOf(X509_get0_notAfter(certificate.get())); }

std::string Credentials::keyAsPem() const {
  const Owned<BIO> bio(BIO_new(BIO_s_secmem()));
  require(PEM_write_bio_PKCS8PrivateKey(bio.get(), key.get(), nullptr, nullptr, 0, nullptr, nullptr) == 1,
          "write a key");
  return textIn(*bio);
}

std::string Credentials::certificateAsPem() const {
  const Owned<BIO> bio(BIO_new(BIO_s_mem()));
  require(PEM_write_bio_X509(bio.get(), certificate.get()) == 1, "write a certificate");
  return textIn(*bio);
}

Credentials makeAuthority(int days) {
  const std::time_t from = std::time(nullptr) - kDay;
  Credentials made = draft("pongsim " + mark(), from, from + (days + std::time_t{1}) * kDay);
  X509& certificate = *made.certificate;
  require(X509_set_issuer_name(&certificate, X509_get_subject_name(&certificate)) == 1, "name an issuer");
  addExtension(certificate, certificate, NID_basic_constraints, "critical,CA:TRUE,pathlen:0");
  addExtension(certificate, certificate, NID_key_usage, "critical,digitalSignature,keyCertSign,cRLSign");
  addExtension(certificate, certificate, NID_subject_key_identifier, "hash");
  require(X509_sign(&certificate, made.key.get(), EVP_sha256()) > 0, "sign a certificate");
  return made;
}

Credentials makeIdentity(const std::string& name, int days, const Credentials& authority) {
  const std::time_t from = std::max(std::time(nullptr) - kDay, authority.validFrom());
  const std::time_t until = std::min(std::time(nullptr) + days * kDay, authority.validUntil());
  Credentials made = draft(name, from, until);
  X509& certificate = *made.certificate;
  X509& issuer = *authority.certificate;
  require(X509_set_issuer_name(&certificate, X509_get_subject_name(&issuer)) == 1, "name an issuer");
  addExtension(certificate, issuer, NID_basic_constraints, "critical,CA:FALSE");
  addExtension(certificate, issuer, NID_key_usage, "critical,digitalSignature,keyAgreement");
  // no emailProtection, so that this certificate can't sign permissions: Fast DDS 2.9 accepts permissions signed by any
  // certificate of the authority
  addExtension(certificate, issuer, NID_ext_key_usage, "clientAuth,serverAuth");
  addExtension(certificate, issuer, NID_subject_key_identifier, "hash");
  require(X509_sign(&certificate, authority.key.get(), EVP_sha256()) > 0, "sign a certificate");
  return made;
}

Credentials readCredentials(const std::filesystem::path& certificate, const std::filesystem::path& key) {
  const std::string certificateText = readKeystoreFile(certificate.string());
  const std::string keyText = readSecretFile(key.string());
  Credentials read{
      std::unique_ptr<EVP_PKEY, Free>(PEM_read_bio_PrivateKey(readable(keyText).get(), nullptr, noPassword, nullptr)),
      std::unique_ptr<X509, Free>(PEM_read_bio_X509(readable(certificateText).get(), nullptr, nullptr, nullptr))};
  ERR_clear_error();
  if (!read.certificate) throw KeystoreError(certificate.string() + " is not a certificate in PEM format");
  if (!read.key) throw KeystoreError(key.string() + " is not a private key in PEM format without a password");
  if (X509_check_private_key(read.certificate.get(), read.key.get()) != 1) {
    ERR_clear_error();
    throw KeystoreError(key.string() + " is not the key of " + certificate.string());
  }
  return read;
}

std::string signedBy(const Credentials& authority, const std::string& text) {
  constexpr int kFlags = PKCS7_DETACHED | PKCS7_TEXT | PKCS7_STREAM;
  const Owned<BIO> content = readable(text);
  const Owned<PKCS7> signature(
      PKCS7_sign(authority.certificate.get(), authority.key.get(), nullptr, content.get(), kFlags));
  const Owned<BIO> out(BIO_new(BIO_s_mem()));
  require(signature && SMIME_write_PKCS7(out.get(), signature.get(), content.get(), kFlags) == 1, "sign a document");
  return textIn(*out);
}

}  // namespace pongsim::security
