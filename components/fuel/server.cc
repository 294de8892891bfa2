#include "fuel/server.hh"

#include <algorithm>
#include <charconv>
#include <iterator>

#include "fuel/failure.hh"

namespace pongsim::fuel {

namespace {

/// Limit of pages of a list, in case a server never reports the last one.
constexpr int kMostPages = 10'000;
constexpr std::size_t kLongestLink = 16'384;

int versionIn(const Answer& answer) {
  for (const char* name : {"x-ign-resource-version", "x-gz-resource-version"}) {
    const std::string text = answer.header(name);
    int version = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), version);
    if (error == std::errc() && end == text.data() + text.size() && version > 0 && version <= 1'000'000) return version;
  }
  return 0;
}

/// @return "/1.0/OWNER/models/NAME" of an address, escaped for a request.
std::string pathOf(const FuelAddress& address) {
  const std::string url = address.url();
  return url.substr(url.find('/', url.find("://") + 3));
}

std::string encoded(const std::string& text) {
  FuelAddress address;
  address.name = text;
  const std::string url = address.url();
  return url.substr(url.rfind('/') + 1);
}

}  // namespace

std::optional<Collection> parseCollection(const std::string& address) {
  constexpr std::string_view kKind = "/collections/";
  const std::size_t at = address.find(kKind);
  if (at == std::string::npos) return std::nullopt;
  const auto parsedAddress = parseFuelAddress(address.substr(0, at) + "/models/" + address.substr(at + kKind.size()));
  if (!parsedAddress || parsedAddress->version || !parsedAddress->file.empty()) return std::nullopt;
  return Collection{*parsedAddress, parsedAddress->owner, parsedAddress->name};
}

FuelServer::FuelServer(Server server, std::vector<std::string> headers)
    : server_(std::move(server)), headers_(std::move(headers)) {
  if (!server_.token.empty()) headers_.push_back("Private-Token: " + server_.token);
}

Request FuelServer::requestFor(const std::string& path) const {
  return {.url = server_.url + path, .secrets = headers_, .headers = {"Accept: application/json"}};
}

Details FuelServer::details(const FuelAddress& address) {
  return parseDetails(http_.text(requestFor(pathOf(address))));
}

std::vector<Details> FuelServer::pages(const std::string& path) {
  std::vector<Details> all;
  for (int page = 1; page <= kMostPages; ++page) {
    std::string text;
    const Request request = requestFor(path + "?page=" + std::to_string(page));
    const Answer answer = http_.send(
        request, [](const Answer&) {},
        [&](std::string_view part) {
          if (text.size() + part.size() > (std::size_t{64} << 20U)) throw Failure("the server's answer is too large");
          text += part;
        });
    // the page after the last one
    if (page > 1 && answer.status == 404) return all;
    if (answer.status >= 300) refuse(answer);
    std::vector<Details> found = parseDetailsList(text);
    if (found.empty()) return all;
    std::ranges::move(found, std::back_inserter(all));
  }
  return all;
}

std::vector<Details> FuelServer::list(bool worlds, const std::string& owner) {
  const std::string kind = worlds ? "/worlds" : "/models";
  return pages("/1.0" + (owner.empty() ? "" : "/" + encoded(owner)) + kind);
}

std::vector<Details> FuelServer::list(bool worlds, const Collection& collection) {
  return pages("/1.0/" + encoded(collection.owner) + "/collections/" + encoded(collection.name) +
               (worlds ? "/worlds" : "/models"));
}

void FuelServer::remove(const FuelAddress& address) {
  Request request = requestFor(pathOf(address));
  request.method = "DELETE";
  http_.text(request);
}

void FuelServer::zip(const FuelAddress& address, std::uint64_t from, const std::string& validator, bool isLinked,
                     const Begin& begin, const Http::Take& take) {
  const std::string version = address.version ? std::to_string(*address.version) : "tip";
  Request request = requestFor(pathOf(address) + "/" + version + "/" + encoded(address.name) + ".zip?link=true");
  request.headers.clear();
  const auto goOn = [&](Request& each) {
    each.headers.push_back("Range: bytes=" + std::to_string(from) + "-");
    each.headers.push_back("If-Range: " + validator);
  };
  if (from > 0 && !isLinked) goOn(request);

  std::optional<std::string> link;
  int number = 0;
  const Answer answer = http_.send(
      request,
      [&](const Answer& each) {
        number = versionIn(each);
        if (each.header("content-type").starts_with("text/plain")) {
          link.emplace();
        } else {
          begin(number, false, each);
        }
      },
      [&](std::string_view part) {
        if (!link) return take(part);
        if (link->size() + part.size() > kLongestLink) throw Failure("the server's link to the zip file is too large");
        *link += part;
      });
  if (answer.status >= 300) refuse(answer);
  if (!link) return;

  while (!link->empty() && static_cast<unsigned char>(link->back()) <= ' ') link->pop_back();
  const bool isSafe =
      link->starts_with("https://") || (server_.url.starts_with("http://") && link->starts_with("http://"));
  if (!isSafe) throw Failure("the server did not send a link to a zip file: '" + plain(link->substr(0, 200)) + "'");
  // without the token: the link may lead to another host
  Request second{.url = *link};
  if (from > 0 && isLinked) goOn(second);
  const Answer last = http_.send(
      second, [&](const Answer& each) { begin(number, true, each); }, take);
  if (last.status >= 300) refuse(last);
}

}  // namespace pongsim::fuel
