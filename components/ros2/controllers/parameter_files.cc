#include "ros2/controllers/parameter_files.hh"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <system_error>

namespace pongsim::ros2 {

namespace {

using Type = rcl_interfaces::ParameterType;
using Value = rcl_interfaces::ParameterValue;

constexpr int kDeepestParameter = 20;

std::vector<std::string> partsOf(const std::string& name) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (begin < name.size()) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    if (end > begin) parts.push_back(name.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

bool fits(std::span<const std::string> pattern, std::span<const std::string> name) {
  if (pattern.empty()) return name.empty();
  if (pattern.front() == "**") {
    for (std::size_t skipped = 0; skipped <= name.size(); ++skipped) {
      if (fits(pattern.subspan(1), name.subspan(skipped))) return true;
    }
    return false;
  }
  return !name.empty() && (pattern.front() == "*" || pattern.front() == name.front()) &&
         fits(pattern.subspan(1), name.subspan(1));
}

template <class T>
std::optional<T> scalarAs(const YAML::Node& yaml) {
  T value{};
  // quoted text is text
  if (yaml.Tag() == "!" || !YAML::convert<T>::decode(yaml, value)) return std::nullopt;
  return value;
}

Value valueOfScalar(const YAML::Node& yaml) {
  Value value;
  if (const auto whole = scalarAs<std::int64_t>(yaml)) {
    value.type = Type::kParameterInteger;
    value.integer_value = *whole;
  } else if (const auto number = scalarAs<double>(yaml)) {
    value.type = Type::kParameterDouble;
    value.double_value = *number;
  } else if (const auto flag = scalarAs<bool>(yaml)) {
    value.type = Type::kParameterBool;
    value.bool_value = *flag;
  } else {
    value.type = Type::kParameterString;
    value.string_value = yaml.Scalar();
  }
  return value;
}

/// Whole numbers beside others are numbers, and anything beside text is text.
Value valueOfList(const YAML::Node& yaml) {
  std::vector<Value> each;
  for (const YAML::Node& item : yaml) each.push_back(valueOfScalar(item));
  const auto areAll = [&each](auto... types) {
    return std::ranges::all_of(each, [=](const Value& value) { return ((value.type == types) || ...); });
  };
  Value list;
  if (areAll(Type::kParameterInteger)) {
    list.type = Type::kParameterIntegerArray;
    for (const Value& value : each) list.integer_array_value.push_back(value.integer_value);
  } else if (areAll(Type::kParameterInteger, Type::kParameterDouble)) {
    list.type = Type::kParameterDoubleArray;
    for (const Value& value : each) {
      list.double_array_value.push_back(
          value.type == Type::kParameterDouble ? value.double_value : static_cast<double>(value.integer_value));
    }
  } else if (areAll(Type::kParameterBool)) {
    list.type = Type::kParameterBoolArray;
    for (const Value& value : each) list.bool_array_value.push_back(value.bool_value);
  } else {
    list.type = Type::kParameterStringArray;
    for (const YAML::Node& item : yaml) list.string_array_value.push_back(item.Scalar());
  }
  return list;
}

void readValues(const YAML::Node& yaml, const std::string& prefix, ParameterValues& values, int depth) {
  if (depth > kDeepestParameter) return;
  for (const auto& entry : yaml) {
    const std::string name = prefix + entry.first.Scalar();
    if (entry.second.IsMap()) {
      readValues(entry.second, name + ".", values, depth + 1);
    } else if (entry.second.IsSequence()) {
      values[name] = valueOfList(entry.second);
    } else if (entry.second.IsScalar()) {
      values[name] = valueOfScalar(entry.second);
    }
  }
}

}  // namespace

std::string ParameterFiles::read(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return "there is no such file";
  if (!std::filesystem::is_regular_file(file, ignored)) return "it is not a regular file";
  std::vector<Entry> read;
  const auto readNodes = [&read](const auto& self, const YAML::Node& yaml, const std::string& name, int depth) -> void {
    if (!yaml.IsMap() || depth > kDeepestParameter) return;
    for (const auto& entry : yaml) {
      if (entry.first.Scalar() == "ros__parameters") {
        if (!entry.second.IsMap()) continue;
        Entry& node = read.emplace_back();
        node.name = partsOf(name);
        readValues(entry.second, "", node.values, 0);
      } else {
        self(self, entry.second, name + "/" + entry.first.Scalar(), depth + 1);
      }
    }
  };
  try {
    readNodes(readNodes, YAML::LoadFile(file.string()), "", 0);
  } catch (const YAML::Exception& error) {
    const bool hasPlace = error.mark.line >= 0;
    return (hasPlace ? "line " + std::to_string(error.mark.line + 1) + ", column " +
                           std::to_string(error.mark.column + 1) + ": "
                     : "") +
           error.msg;
  }
  entries_.insert(entries_.end(), read.begin(), read.end());
  return {};
}

ParameterValues ParameterFiles::valuesOf(const std::string& node) const {
  ParameterValues values;
  const std::vector<std::string> name = partsOf(node);
  for (const Entry& entry : entries_) {
    if (!fits(entry.name, name)) continue;
    for (const auto& [parameter, value] : entry.values) values[parameter] = value;
  }
  return values;
}

}  // namespace pongsim::ros2
