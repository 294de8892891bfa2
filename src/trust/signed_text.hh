#pragma once

#include <filesystem>
#include <string>

#include "trust/certificate.hh"

namespace pongsim::trust {

/// @return The content of a document signed with S/MIME.
/// @throws KeystoreError if the authority has not signed it, or it has changed since.
std::string signedText(const std::filesystem::path& file, const Certificate& authority);

}  // namespace pongsim::trust
