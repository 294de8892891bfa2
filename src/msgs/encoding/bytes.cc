#include "msgs/encoding/bytes.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/message.h>
#include <google/protobuf/wire_format_lite.h>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace pongsim::msgs {

const std::string& typeName(const Message& message) { return message.GetDescriptor()->full_name(); }

std::size_t byteSize(const Message& message) { return message.ByteSizeLong(); }

void writeBytes(const Message& message, std::span<std::byte> place) {
  message.SerializeWithCachedSizesToArray(reinterpret_cast<std::uint8_t*>(place.data()));
}

std::optional<BulkWriter> BulkWriter::of(const Message& message, const Bulk& bulk) {
  using google::protobuf::FieldDescriptor;
  using google::protobuf::internal::WireFormatLite;
  using google::protobuf::io::CodedOutputStream;
  const FieldDescriptor* field = message.GetDescriptor()->FindFieldByName(bulk.field);
  if (field == nullptr || field->type() != FieldDescriptor::TYPE_BYTES || field->is_repeated() ||
      bulk.size > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    return std::nullopt;
  }
  BulkWriter writer(message, bulk);
  writer.head_ = message.ByteSizeLong();
  // fields can be in any order, so this one may come after the rest
  auto* const begin = reinterpret_cast<std::uint8_t*>(writer.tag_.data());
  std::uint8_t* end =
      WireFormatLite::WriteTagToArray(field->number(), WireFormatLite::WIRETYPE_LENGTH_DELIMITED, begin);
  end = CodedOutputStream::WriteVarint32ToArray(static_cast<std::uint32_t>(bulk.size), end);
  writer.tagSize_ = static_cast<std::size_t>(end - begin);
  return writer;
}

void BulkWriter::write(std::span<std::byte> place) const {
  writeBytes(*message_, place.first(head_));
  std::copy_n(tag_.begin(), tagSize_, place.begin() + static_cast<std::ptrdiff_t>(head_));
  if (bulk_->size > 0) bulk_->write(place.subspan(head_ + tagSize_));
}

bool parseBytes(std::span<const std::byte> bytes, Message& message) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) return false;
  return message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
}

}  // namespace pongsim::msgs
