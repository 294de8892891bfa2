#include "trust/certificate.hh"

#include <openssl/err.h>
#include <openssl/pem.h>

#include "pongsim/program/keystore.hh"
#include "trust/secret_file.hh"

namespace pongsim::trust {

namespace {

std::time_t timeOf(const ASN1_TIME* time) {
  std::tm parts{};
  return ASN1_TIME_to_tm(time, &parts) == 1 ? timegm(&parts) : 0;
}

/// OpenSSL's callback for passwords. Supplies none, and sets the bool that `wasCalled` points to.
int noPassword(char*, int, int, void* wasCalled) {
  *static_cast<bool*>(wasCalled) = true;
  return -1;
}

}  // namespace

std::string Certificate::subject() const {
  const Owned<BIO> text(BIO_new(BIO_s_mem()));
  X509_NAME_print_ex(text.get(), X509_get_subject_name(x509.get()), 0, XN_FLAG_RFC2253 & ~ASN1_STRFLGS_ESC_MSB);
  return textIn(*text);
}

std::time_t Certificate::validFrom() const { return timeOf(X509_get0_notBefore(x509.get())); }

std::time_t Certificate::validUntil() const { return timeOf(X509_get0_notAfter(x509.get())); }

std::string dayOf(std::time_t time) {
  std::tm parts{};
  gmtime_r(&time, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%F", &parts);
  return text;
}

Certificate readCertificate(const std::filesystem::path& file) {
  const std::string text = contentsOf(file);
  const Owned<BIO> bio = readable(text);
  Certificate certificate{file, Owned<X509>(PEM_read_bio_X509(bio.get(), nullptr, nullptr, nullptr))};
  ERR_clear_error();
  if (!certificate.x509) throw KeystoreError(file.string() + " is not a certificate in PEM format");
  return certificate;
}

Owned<EVP_PKEY> readKey(const std::filesystem::path& file) {
  const std::string text = contentsOf(file);
  requireSecret(file);
  const Owned<BIO> bio = readable(text);
  bool needsPassword = false;
  Owned<EVP_PKEY> key(PEM_read_bio_PrivateKey(bio.get(), nullptr, noPassword, &needsPassword));
  ERR_clear_error();
  if (needsPassword) {
    throw KeystoreError(file.string() + " is protected by a password, which is not supported",
                        "openssl pkey -in " + file.string() + " -out key.pem removes it");
  }
  if (!key) throw KeystoreError(file.string() + " is not a private key in PEM format");
  return key;
}

void requireValidNow(const Certificate& certificate) {
  const std::time_t now = std::time(nullptr);
  if (certificate.validUntil() < now) {
    throw KeystoreError(certificate.file.string() + " expired on " + dayOf(certificate.validUntil()),
                        "make a new one with 'pongsim security', or check this machine's clock");
  }
  if (certificate.validFrom() > now) {
    throw KeystoreError(certificate.file.string() + " is not valid before " + dayOf(certificate.validFrom()),
                        "check this machine's clock: it says " + dayOf(now));
  }
}

void requireIssuedBy(const Certificate& certificate, const Certificate& authority) {
  const Owned<X509_STORE> store(X509_STORE_new());
  X509_STORE_add_cert(store.get(), authority.x509.get());
  const Owned<X509_STORE_CTX> context(X509_STORE_CTX_new());
  X509_STORE_CTX_init(context.get(), store.get(), certificate.x509.get(), nullptr);
  const bool isVerified = X509_verify_cert(context.get()) == 1;
  const int reason = X509_STORE_CTX_get_error(context.get());
  ERR_clear_error();
  if (isVerified) return;
  const bool isForeign =
      reason == X509_V_ERR_UNABLE_TO_GET_ISSUER_CERT_LOCALLY || reason == X509_V_ERR_UNABLE_TO_GET_ISSUER_CERT ||
      reason == X509_V_ERR_CERT_SIGNATURE_FAILURE || reason == X509_V_ERR_UNABLE_TO_VERIFY_LEAF_SIGNATURE ||
      reason == X509_V_ERR_DEPTH_ZERO_SELF_SIGNED_CERT;
  throw KeystoreError(certificate.file.string() + " is not signed by the authority in " + authority.file.string() +
                          " (" + authority.subject() + ")" +
                          (isForeign ? "" : std::string(": ") + X509_verify_cert_error_string(reason)),
                      isForeign ? "use a certificate and an authority of the same keystore" : "");
}

void requireKeyOf(const Certificate& certificate, EVP_PKEY& key, const std::filesystem::path& keyFile) {
  const bool isKey = X509_check_private_key(certificate.x509.get(), &key) == 1;
  ERR_clear_error();
  if (!isKey) throw KeystoreError(keyFile.string() + " is not the key of " + certificate.file.string());
}

}  // namespace pongsim::trust
