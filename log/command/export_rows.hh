#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "log/command/decoder.hh"
#include "pongsim/messages/field_path.hh"

namespace pongsim::log {

/// @return The text as a value of RFC 4180: in quotes where it would be more than one otherwise.
std::string csvValue(const std::string& text);

/// The messages of one topic as lines, each with the time of its record [s] in front.
class ExportRows {
 public:
  /// @param fields Paths of values; empty: the whole message, as CSV all single numbers, texts and booleans.
  /// @throws Failure where one is not in the type.
  ExportRows(const Definition& definition, std::string topic, const std::string& type,
             const std::vector<std::string>& fields, bool asCsv);

  /// @return The first line of a table.
  std::string csvHeader() const;
  /// @throws Failure where the payload is no message of the type, naming the topic and the time.
  std::string row(std::int64_t timeNs, std::string_view payload);

 private:
  std::string csvRow(const Message& message) const;
  std::string jsonRow(const Message& message) const;

  std::string topic_, type_;
  bool asCsv_;
  std::unique_ptr<Decoder> decoder_;
  std::vector<FieldPath> fields_;
};

}  // namespace pongsim::log
