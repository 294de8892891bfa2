#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

struct lws;

namespace pongsim::web {

/// @param path As the browser asks for it: "/main.js"; "/" is index.html.
/// @return The file in `folder`, which it does not leave by any way; nothing where there is none.
std::optional<std::filesystem::path> pageFile(const std::filesystem::path& folder, std::string_view path);

/// @return What stands in `?name=value` of a request, or in what it has as its bearer token.
std::string tokenOf(lws* request);

/// @return What stands in a header of that number (lws_token_indexes); empty where it is not there.
std::string headerOf(lws* request, int number);

/// Answers with a short text.
/// @return Whether the connection goes on.
bool answerText(lws* request, int status, const std::string& text);

/// Answers with a file, in pieces as the socket takes them; with the compressed one beside it (FILE.gz) where there is
/// one and the browser takes it.
/// @param origin A page of others that may read it; empty: none may.
/// @return What the library's callback is to return.
int answerFile(lws* request, const std::filesystem::path& file, const std::string& origin);

}  // namespace pongsim::web
