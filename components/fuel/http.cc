#include "fuel/http.hh"

#include <curl/curl.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <exception>
#include <memory>
#include <mutex>

#include "fuel/failure.hh"
#include "fuel/interruption.hh"
#include "shared/program/stop_signal.hh"

namespace pongsim::fuel {

namespace {

constexpr int kMostRedirections = 10;
/// CURLOPT_LOW_SPEED_LIMIT: a slower transfer counts as stalled [bytes/s]. And its default duration [s].
constexpr long kSilence = 100;
constexpr long kPatience = 30;
constexpr std::size_t kMostHeaders = std::size_t{1} << 20U;

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

long patience() {
  const std::string text = variable("PONGSIM_FUEL_TIMEOUT");
  long seconds = kPatience;
  if (text.empty()) return seconds;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
  if (error != std::errc() || end != text.data() + text.size() || seconds < 1 || seconds > 86'400) {
    throw Failure("PONGSIM_FUEL_TIMEOUT is '" + text + "', not a number of seconds from 1 to 86400");
  }
  return seconds;
}

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(),
                         [](unsigned char each) { return static_cast<char>(std::tolower(each)); });
  return lower;
}

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == text.npos ? "" : std::string(text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
}

bool isRedirection(int status) {
  return status == 301 || status == 302 || status == 303 || status == 307 || status == 308;
}

std::string hostOf(std::string_view url) {
  const std::string origin = originOf(url);
  return origin.substr(std::min(origin.find("://") + 3, origin.size()));
}

}  // namespace

std::string Answer::header(const std::string& name) const {
  const auto found = headers.find(name);
  return found == headers.end() ? "" : found->second;
}

std::uint64_t Answer::length() const {
  const std::string text = header("content-length");
  std::uint64_t length = 0;
  std::from_chars(text.data(), text.data() + text.size(), length);
  return length;
}

/// A single request, as libcurl's callbacks need it.
struct Http::Transfer {
  CURL* curl = nullptr;
  const Begin* begin = nullptr;
  const Take* take = nullptr;
  Answer answer;
  bool hasBegun = false;
  std::size_t headerBytes = 0;
  /// An exception thrown in a callback, rethrown after the transfer, because it must not pass through libcurl's C code.
  std::exception_ptr thrown;

  void beginBody() {
    if (hasBegun) return;
    hasBegun = true;
    long status = 0;
    curl_easy_getinfo(curl, CURLINFO_RESPONSE_CODE, &status);
    answer.status = static_cast<int>(status);
    if (answer.status < 300) (*begin)(answer);
  }

  static std::size_t header(char* text, std::size_t size, std::size_t count, void* self) {
    auto& transfer = *static_cast<Transfer*>(self);
    const std::string_view line(text, size * count);
    if ((transfer.headerBytes += line.size()) > kMostHeaders) return 0;
    // a new status line: discards headers of a proxy or of "100 Continue"
    if (line.starts_with("HTTP/")) transfer.answer.headers.clear();
    const std::size_t colon = line.find(':');
    if (colon != line.npos) {
      transfer.answer.headers[lowerCase(trimmed(line.substr(0, colon)))] = trimmed(line.substr(colon + 1));
    }
    return line.size();
  }

  static std::size_t body(char* text, std::size_t size, std::size_t count, void* self) {
    auto& transfer = *static_cast<Transfer*>(self);
    try {
      transfer.beginBody();
      // the body of an error or redirection is discarded
      if (transfer.answer.status < 300) (*transfer.take)({text, size * count});
      return size * count;
    } catch (...) {
      transfer.thrown = std::current_exception();
      return 0;
    }
  }

  static int progress(void*, curl_off_t, curl_off_t, curl_off_t, curl_off_t) { return cli::isStopped() ? 1 : 0; }
};

Http::Http() {
  static std::once_flag once;
  std::call_once(once, [] { curl_global_init(CURL_GLOBAL_DEFAULT); });
  curl_ = curl_easy_init();
  if (curl_ == nullptr) throw Failure("libcurl can't be started");
}

Http::~Http() { curl_easy_cleanup(curl_); }

namespace {

/// @throws The failure for a libcurl error.
[[noreturn]] void explain(CURLcode code, const char* detail, const std::string& url) {
  const std::string host = hostOf(url);
  const std::string said = *detail != '\0' ? detail : curl_easy_strerror(code);
  switch (code) {
    case CURLE_ABORTED_BY_CALLBACK:
      throw Interrupted();
    case CURLE_COULDNT_RESOLVE_HOST:
    case CURLE_COULDNT_RESOLVE_PROXY:
      throw Failure("the server " + host + " can't be found: " + said,
                    "is there a network? use --offline to use only the cache");
    case CURLE_COULDNT_CONNECT:
      throw PassingFailure("the server " + host + " can't be reached: " + said,
                           "is there a network? use --offline to use only the cache");
    case CURLE_OPERATION_TIMEDOUT:
      throw PassingFailure("the server " + host + " sent almost nothing for " + std::to_string(patience()) + " seconds",
                           "try again later to resume; PONGSIM_FUEL_TIMEOUT sets the seconds to wait");
    case CURLE_PEER_FAILED_VERIFICATION:
    case CURLE_SSL_CACERT_BADFILE:
    case CURLE_SSL_ISSUER_ERROR:
      throw Failure("the certificate of " + host + " is not trusted: " + said,
                    "set SSL_CERT_FILE to trust other certificates than the system's");
    case CURLE_PARTIAL_FILE:
      throw PassingFailure("the server " + host + " closed the connection: " + said, "try again to resume");
    case CURLE_UNSUPPORTED_PROTOCOL:
    case CURLE_URL_MALFORMAT:
      throw Failure("'" + url + "' is not an address to download from");
    default:
      throw PassingFailure("the server " + host + " failed: " + said, "try again to resume");
  }
}

}  // namespace

bool Http::sendOnce(const Request& request, bool isFirst, Transfer& transfer) {
  CURL* curl = curl_;
  curl_easy_reset(curl);
  char detail[CURL_ERROR_SIZE] = "";
  const bool isPlain = request.url.starts_with("http://");
  const std::string bundle =
      !variable("SSL_CERT_FILE").empty() ? variable("SSL_CERT_FILE") : variable("CURL_CA_BUNDLE");
  const long seconds = patience();
  const std::string url = transfer.answer.url;
  curl_easy_setopt(curl, CURLOPT_URL, url.c_str());
  curl_easy_setopt(curl, CURLOPT_CUSTOMREQUEST, request.method == "GET" ? nullptr : request.method.c_str());
  curl_easy_setopt(curl, CURLOPT_USERAGENT, "pongsim/" PONGSIM_VERSION);
  curl_easy_setopt(curl, CURLOPT_PROTOCOLS_STR, isPlain ? "http,https" : "https");
  curl_easy_setopt(curl, CURLOPT_SSL_VERIFYPEER, 1L);
  curl_easy_setopt(curl, CURLOPT_SSL_VERIFYHOST, 2L);
  if (!bundle.empty()) curl_easy_setopt(curl, CURLOPT_CAINFO, bundle.c_str());
  curl_easy_setopt(curl, CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(curl, CURLOPT_ERRORBUFFER, detail);
  curl_easy_setopt(curl, CURLOPT_CONNECTTIMEOUT, seconds);
  curl_easy_setopt(curl, CURLOPT_LOW_SPEED_LIMIT, kSilence);
  curl_easy_setopt(curl, CURLOPT_LOW_SPEED_TIME, seconds);
  curl_easy_setopt(curl, CURLOPT_NOPROGRESS, 0L);
  curl_easy_setopt(curl, CURLOPT_XFERINFOFUNCTION, &Transfer::progress);
  curl_easy_setopt(curl, CURLOPT_HEADERFUNCTION, &Transfer::header);
  curl_easy_setopt(curl, CURLOPT_HEADERDATA, &transfer);
  curl_easy_setopt(curl, CURLOPT_WRITEFUNCTION, &Transfer::body);
  curl_easy_setopt(curl, CURLOPT_WRITEDATA, &transfer);

  std::unique_ptr<curl_slist, decltype(&curl_slist_free_all)> headers(nullptr, &curl_slist_free_all);
  const auto add = [&](const std::string& header) {
    curl_slist* more = curl_slist_append(headers.get(), header.c_str());
    if (more == nullptr) throw std::bad_alloc();
    static_cast<void>(headers.release());
    headers.reset(more);
  };
  for (const std::string& header : request.headers) add(header);
  if (isFirst || originOf(url) == originOf(request.url)) {
    for (const std::string& header : request.secrets) add(header);
  }
  curl_easy_setopt(curl, CURLOPT_HTTPHEADER, headers.get());

  const CURLcode code = curl_easy_perform(curl);
  if (transfer.thrown) std::rethrow_exception(transfer.thrown);
  if (code != CURLE_OK) explain(code, detail, url);
  // for a response without a body, whose callback was not called
  transfer.beginBody();
  char* next = nullptr;
  if (!isRedirection(transfer.answer.status)) return true;
  curl_easy_getinfo(curl, CURLINFO_REDIRECT_URL, &next);
  if (next == nullptr) throw Failure("the server " + hostOf(url) + " redirects without an address");
  const std::string target = next;
  if (!isPlain && !target.starts_with("https://")) {
    throw Failure("the server " + hostOf(url) + " redirects to an unsafe address: " + target);
  }
  transfer.answer = {};
  transfer.answer.url = target;
  return false;
}

Answer Http::send(const Request& request, const Begin& begin, const Take& take) {
  checkInterruption();
  Transfer transfer;
  transfer.curl = curl_;
  transfer.begin = &begin;
  transfer.take = &take;
  transfer.answer.url = request.url;
  for (int count = 0; count <= kMostRedirections; ++count) {
    transfer.hasBegun = false;
    if (sendOnce(request, count == 0, transfer)) return transfer.answer;
  }
  throw Failure("the server " + hostOf(request.url) + " redirects too often: more than " +
                std::to_string(kMostRedirections) + " redirections, the last one to " + transfer.answer.url);
}

std::string Http::text(const Request& request, std::size_t most) {
  std::string text;
  const Answer answer = send(
      request, [](const Answer&) {},
      [&](std::string_view part) {
        if (text.size() + part.size() > most) throw Failure("the answer of " + hostOf(request.url) + " is too large");
        text += part;
      });
  if (answer.status >= 300) refuse(answer);
  return text;
}

void refuse(const Answer& answer) {
  const std::string host = hostOf(answer.url);
  const std::string status = std::to_string(answer.status);
  if (answer.status == 404 || answer.status == 410) {
    throw Failure("the server " + host + " does not have it (status " + status + ")", "is the address right?");
  }
  if (answer.status == 401 || answer.status == 403) {
    throw Failure("the server " + host + " does not allow it (status " + status + ")",
                  "private models need a token: private-token of the server in config.yaml, or --header");
  }
  if (answer.status >= 500 || answer.status == 429) {
    throw PassingFailure("the server " + host + " failed (status " + status + ")", "try again later");
  }
  throw Failure("the server " + host + " refused (status " + status + ")");
}

std::string originOf(std::string_view url) {
  const std::size_t mark = url.find("://");
  if (mark == url.npos) return std::string(url);
  return lowerCase(url.substr(0, std::min(url.find_first_of("/?#", mark + 3), url.size())));
}

}  // namespace pongsim::fuel
