#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

struct lws;

namespace pongsim::web {

/// @param path As requested by the browser: "/main.js"; "/" is index.html.
/// @return The file in `folder`, never outside of it; nothing if there is none.
std::optional<std::filesystem::path> pageFile(const std::filesystem::path& folder, std::string_view path);

/// @return The token in a request: from `?name=value`, or the bearer token.
std::string tokenOf(lws* request);

/// @return The value of a header given by number (lws_token_indexes); empty if it is missing.
std::string headerOf(lws* request, int number);

/// Responds with a short text.
/// @return Whether the connection stays open.
bool answerText(lws* request, int status, const std::string& text);

/// Responds with a file, in pieces as the socket takes them. Sends the compressed version (FILE.gz) if there is one and
/// the browser accepts it.
/// @param origin Another page's origin that may read it; empty: none.
/// @return What the library's callback must return.
int answerFile(lws* request, const std::filesystem::path& file, const std::string& origin);

}  // namespace pongsim::web
