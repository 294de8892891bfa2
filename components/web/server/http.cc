#include "web/server/http.hh"

#include <libwebsockets.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <system_error>
#include <vector>

#include "web/server/media_type.hh"

namespace pongsim::web {

namespace {

constexpr std::string_view kBearer = "Bearer ";
// Longer tokens cannot be ours.
constexpr int kLongestToken = 256;

}  // namespace

std::optional<std::filesystem::path> pageFile(const std::filesystem::path& folder, std::string_view path) {
  if (folder.empty() || path.empty() || path.front() != '/' || path.find('\0') != std::string_view::npos) return {};
  path.remove_prefix(1);
  const std::filesystem::path relative = path.empty() ? "index.html" : std::filesystem::path(path);
  if (relative.is_absolute() || mediaType(relative).empty()) return {};
  std::error_code error;
  const std::filesystem::path root = std::filesystem::canonical(folder, error);
  if (error) return {};
  const std::filesystem::path file = std::filesystem::canonical(root / relative, error);
  if (error || !std::filesystem::is_regular_file(file, error)) return {};
  if (std::ranges::mismatch(root, file).in1 != root.end()) return {};
  return file;
}

std::string headerOf(lws* request, int number) {
  const auto token = static_cast<lws_token_indexes>(number);
  const int length = lws_hdr_total_length(request, token);
  if (length <= 0) return {};
  std::vector<char> text(static_cast<std::size_t>(length) + 1);
  if (lws_hdr_copy(request, text.data(), length + 1, token) < 0) return {};
  return text.data();
}

std::string tokenOf(lws* request) {
  std::array<char, kLongestToken> text{};
  if (const char* const value = lws_get_urlarg_by_name(request, "token=", text.data(), kLongestToken)) return value;
  const std::string authorization = headerOf(request, WSI_TOKEN_HTTP_AUTHORIZATION);
  return authorization.starts_with(kBearer) ? authorization.substr(kBearer.size()) : std::string{};
}

bool answerText(lws* request, int status, const std::string& text) {
  std::vector<unsigned char> buffer(LWS_PRE + 2048 + text.size());
  unsigned char* const begin = buffer.data() + LWS_PRE;
  unsigned char* at = begin;
  unsigned char* const end = buffer.data() + LWS_PRE + 2048;
  if (lws_add_http_common_headers(request, static_cast<unsigned>(status), "text/plain; charset=utf-8", text.size(), &at,
                                  end) != 0 ||
      lws_finalize_write_http_header(request, begin, &at, end) != 0)
    return false;
  std::memcpy(begin, text.data(), text.size());
  return lws_write(request, begin, text.size(), LWS_WRITE_HTTP_FINAL) == static_cast<int>(text.size());
}

int answerFile(lws* request, const std::filesystem::path& file, const std::string& origin) {
  std::string headers = "cross-origin-resource-policy: ";
  headers += origin.empty() ? "same-origin\r\n" : "cross-origin\r\n";
  if (!origin.empty()) headers += "access-control-allow-origin: " + origin + "\r\nvary: origin\r\n";
  std::filesystem::path sent = file;
  sent += ".gz";
  std::error_code error;
  // a symbolic link might lead out of the folder
  const bool isCompressed = headerOf(request, WSI_TOKEN_HTTP_ACCEPT_ENCODING).find("gzip") != std::string::npos &&
                            std::filesystem::symlink_status(sent, error).type() == std::filesystem::file_type::regular;
  if (isCompressed) {
    headers += "content-encoding: gzip\r\n";
  } else {
    sent = file;
  }
  const int result = lws_serve_http_file(request, sent.c_str(), std::string(mediaType(file)).c_str(), headers.c_str(),
                                         static_cast<int>(headers.size()));
  if (result < 0) return -1;
  // everything has been sent
  return result > 0 && lws_http_transaction_completed(request) != 0 ? -1 : 0;
}

}  // namespace pongsim::web
