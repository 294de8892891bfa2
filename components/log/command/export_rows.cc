#include "log/command/export_rows.hh"

#include <google/protobuf/message.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "log/command/times.hh"
#include "log/store/failure.hh"

namespace pongsim::log {

namespace {

std::string jsonText(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// @return The value at the path: a number if JSON can express it, else as in protobuf's JSON.
std::string jsonValue(const FieldPath& field, const Message& message) {
  const std::optional<std::string> text = field.valueIn(message);
  if (!text) return "null";
  if (!field.isNumber()) return jsonText(*text);
  const double number = field.numberIn(message).value_or(0);
  if (std::isnan(number)) return "\"NaN\"";
  if (std::isinf(number)) return number > 0 ? "\"Infinity\"" : "\"-Infinity\"";
  return *text;
}

}  // namespace

std::string csvValue(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + "\"";
}

ExportRows::ExportRows(const Definition& definition, std::string topic, const std::string& type,
                       const std::vector<std::string>& fields, bool asCsv)
    : topic_(std::move(topic)), type_(type), asCsv_(asCsv), decoder_(makeDecoder(definition, type)) {
  const google::protobuf::Descriptor& descriptor = *decoder_->prototype().GetDescriptor();
  for (const std::string& path : asCsv&& fields.empty() ? scalarPaths(descriptor) : fields) {
    MessageError error;
    std::optional<FieldPath> field = FieldPath::parse(descriptor, path, error);
    if (!field) throw Failure(error.message, error.hint);
    fields_.push_back(*std::move(field));
  }
}

std::string ExportRows::csvHeader() const {
  std::string header = "time_s";
  for (const FieldPath& field : fields_) header += "," + csvValue(field.text());
  return header + "\n";
}

std::string ExportRows::row(std::int64_t timeNs, std::string_view payload) {
  try {
    const Message& message = decoder_->decode(payload);
    const std::string time = secondsText(timeNs);
    return asCsv_ ? time + csvRow(message) + "\n"
                  : "{\"time_s\": " + time + ", \"topic\": " + jsonText(topic_) + jsonRow(message) + "}\n";
  } catch (const std::exception& error) {
    throw Failure("the message of '" + topic_ + "' at " + secondsText(timeNs) + " s can't be read: " + error.what());
  }
}

std::string ExportRows::csvRow(const Message& message) const {
  std::string row;
  for (const FieldPath& field : fields_) row += "," + csvValue(field.valueIn(message).value_or(""));
  return row;
}

std::string ExportRows::jsonRow(const Message& message) const {
  if (fields_.empty()) return ", \"type\": " + jsonText(type_) + ", \"message\": " + decoder_->jsonOf(message);
  std::string row;
  for (const FieldPath& field : fields_) row += ", " + jsonText(field.text()) + ": " + jsonValue(field, message);
  return row;
}

}  // namespace pongsim::log
