#include "fuel/details.hh"

#include <nlohmann/json.hpp>
#include <utility>

#include "fuel/failure.hh"

namespace pongsim::fuel {

std::string plain(std::string text) {
  for (char& each : text) {
    if (static_cast<unsigned char>(each) < 0x20 || each == 0x7f) each = ' ';
  }
  return text;
}

namespace {

using Json = nlohmann::json;

std::string textIn(const Json& json, const char* name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_string() ? plain(found->get<std::string>()) : "";
}

template <class Number>
Number numberIn(const Json& json, const char* name) {
  const auto found = json.find(name);
  if (found == json.end() || !found->is_number_unsigned()) return Number{};
  const auto number = found->get<std::uint64_t>();
  return std::in_range<Number>(number) ? static_cast<Number>(number) : Number{};
}

Details detailsOf(const Json& json) {
  if (!json.is_object()) throw Failure("the server's answer is not a list of models");
  Details details;
  details.owner = textIn(json, "owner");
  details.name = textIn(json, "name");
  details.version = numberIn<int>(json, "version");
  details.bytes = numberIn<std::uint64_t>(json, "filesize");
  details.isPrivate = json.contains("private") && json["private"].is_boolean() && json["private"].get<bool>();
  details.description = textIn(json, "description");
  details.license = textIn(json, "license_name");
  details.created = textIn(json, "createdAt");
  details.updated = textIn(json, "updatedAt");
  if (const auto tags = json.find("tags"); tags != json.end() && tags->is_array()) {
    for (const Json& tag : *tags) {
      if (tag.is_string()) details.tags.push_back(plain(tag.get<std::string>()));
    }
  }
  return details;
}

Json parsed(std::string_view text) {
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) throw PassingFailure("the server's answer can't be read: it is not JSON", "try again later");
  return json;
}

}  // namespace

Details parseDetails(std::string_view json) {
  Details details = detailsOf(parsed(json));
  if (details.name.empty()) throw Failure("the server's answer does not describe a model or world");
  return details;
}

std::vector<Details> parseDetailsList(std::string_view json) {
  const Json list = parsed(json);
  std::vector<Details> details;
  if (list.is_null()) return details;
  if (!list.is_array()) throw Failure("the server's answer is not a list of models");
  for (const Json& each : list) details.push_back(detailsOf(each));
  return details;
}

}  // namespace pongsim::fuel
