#pragma once

#include <filesystem>
#include <string>

#include "trust/certificate.hh"

namespace pongsim::trust {

/// @return What stands in a document that is signed by S/MIME.
/// @throws KeystoreError where the authority has not signed it, or it is not as it was then.
std::string signedText(const std::filesystem::path& file, const Certificate& authority);

}  // namespace pongsim::trust
