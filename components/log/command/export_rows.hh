#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "log/command/decoder.hh"
#include "pongsim/messages/field_path.hh"

namespace pongsim::log {

/// @return The text as a CSV field (RFC 4180), quoted if necessary.
std::string csvValue(const std::string& text);

/// Formats the messages of one topic as lines that start with the record's time [s].
class ExportRows {
 public:
  /// @param fields Paths of values; empty: the whole message; for CSV, all single numbers, texts and booleans.
  /// @throws Failure if the type does not have one of them.
  ExportRows(const Definition& definition, std::string topic, const std::string& type,
             const std::vector<std::string>& fields, bool asCsv);

  /// @return The header line of a table.
  std::string csvHeader() const;
  /// @throws Failure, with the topic and time, if the payload is not a message of the type.
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
