#include "trust/signed_text.hh"

#include <openssl/err.h>

#include "pongsim/program/keystore.hh"
#include "trust/secret_file.hh"

namespace pongsim::trust {

std::string signedText(const std::filesystem::path& file, const Certificate& authority) {
  const std::string text = contentsOf(file);
  const Owned<BIO> bio = readable(text);
  BIO* content = nullptr;
  const Owned<PKCS7> signature(SMIME_read_PKCS7(bio.get(), &content));
  const Owned<BIO> ownedContent(content);
  if (!signature) {
    ERR_clear_error();
    throw KeystoreError(file.string() + " is not an S/MIME signed document");
  }
  const Owned<X509_STORE> store(X509_STORE_new());
  X509_STORE_add_cert(store.get(), authority.x509.get());
  // the authority itself, not somebody with a certificate from it: an identity must not grant itself permissions
  const Owned<STACK_OF(X509)> signers(sk_X509_new_null());
  sk_X509_push(signers.get(), authority.x509.get());
  const Owned<BIO> out(BIO_new(BIO_s_mem()));
  const bool isVerified =
      PKCS7_verify(signature.get(), signers.get(), store.get(), content, out.get(), PKCS7_TEXT | PKCS7_NOINTERN) == 1;
  const int reason = ERR_GET_REASON(ERR_peek_last_error());
  ERR_clear_error();
  if (isVerified) return textIn(*out);
  if (reason == PKCS7_R_DIGEST_FAILURE || reason == PKCS7_R_SIGNATURE_FAILURE) {
    throw KeystoreError(file.string() + " has been changed since it was signed", "sign it again");
  }
  throw KeystoreError(file.string() + " is not signed by the authority in " + authority.file.string() + " (" +
                          authority.subject() + ")",
                      "use both from the same keystore");
}

}  // namespace pongsim::trust
