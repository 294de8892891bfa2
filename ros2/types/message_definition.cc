#include "ros2/types/message_definition.hh"

namespace pongsim::ros2::detail {

namespace {

constexpr std::size_t kLineLength = 80;

}  // namespace

std::string nameInMsg(std::string_view name) {
  const std::size_t package = name.find('/'), last = name.rfind('/');
  return std::string(name.substr(0, package)) + std::string(name.substr(last));
}

std::string joinFieldLists(const std::string& name, const FieldLists& all) {
  std::string text = all.at(name);
  for (const auto& [each, fields] : all) {
    if (each == name) continue;
    text += std::string(kLineLength, '=') + "\nMSG: " + nameInMsg(each) + "\n" + fields;
  }
  return text;
}

}  // namespace pongsim::ros2::detail
