#include "msgs/fields/field_reader.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <google/protobuf/reflection.h>

namespace pongsim::msgs {

using google::protobuf::FieldDescriptor;

const FieldDescriptor* FieldReader::find(const char* field) const {
  return message_->GetDescriptor()->FindFieldByName(field);
}

double FieldReader::number(const char* field) const {
  const FieldDescriptor* found = find(field);
  const auto* reflection = message_->GetReflection();
  return found->cpp_type() == FieldDescriptor::CPPTYPE_FLOAT ? reflection->GetFloat(*message_, found)
                                                             : reflection->GetDouble(*message_, found);
}

std::int64_t FieldReader::whole(const char* field) const {
  const FieldDescriptor* found = find(field);
  const auto* reflection = message_->GetReflection();
  switch (found->cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      return reflection->GetInt32(*message_, found);
    case FieldDescriptor::CPPTYPE_UINT32:
      return reflection->GetUInt32(*message_, found);
    case FieldDescriptor::CPPTYPE_ENUM:
      return reflection->GetEnumValue(*message_, found);
    default:
      return reflection->GetInt64(*message_, found);
  }
}

std::vector<double> FieldReader::numbers(const char* field) const {
  const auto all = message_->GetReflection()->GetRepeatedFieldRef<double>(*message_, find(field));
  return {all.begin(), all.end()};
}

std::string FieldReader::bytes(const char* field) const {
  return message_->GetReflection()->GetString(*message_, find(field));
}

FieldReader FieldReader::inside(const char* field) const {
  return FieldReader(message_->GetReflection()->GetMessage(*message_, find(field)));
}

}  // namespace pongsim::msgs
