#pragma once

#include <openssl/bio.h>
#include <openssl/evp.h>
#include <openssl/pkcs7.h>
#include <openssl/x509.h>
#include <openssl/x509_vfy.h>

#include <memory>
#include <string>
#include <string_view>

namespace pongsim::trust {

struct Free {
  void operator()(BIO* bio) const { BIO_free_all(bio); }
  void operator()(EVP_PKEY* key) const { EVP_PKEY_free(key); }
  void operator()(PKCS7* signature) const { PKCS7_free(signature); }
  void operator()(X509* certificate) const { X509_free(certificate); }
  /// Does not free the certificates, which others own.
  void operator()(STACK_OF(X509) * certificates) const { sk_X509_free(certificates); }
  void operator()(X509_STORE* store) const { X509_STORE_free(store); }
  void operator()(X509_STORE_CTX* context) const { X509_STORE_CTX_free(context); }
};

/// An object created by OpenSSL, freed by its owner.
template <class T>
using Owned = std::unique_ptr<T, Free>;

/// @param text Must outlive the result.
/// @return An object from which OpenSSL reads the text.
inline Owned<BIO> readable(std::string_view text) {
  return Owned<BIO>(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
}

/// @return The text written to it.
inline std::string textIn(BIO& bio) {
  char* data = nullptr;
  const long size = BIO_get_mem_data(&bio, &data);
  return size > 0 ? std::string(data, static_cast<std::size_t>(size)) : std::string();
}

}  // namespace pongsim::trust
