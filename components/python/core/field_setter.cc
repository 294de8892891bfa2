#include "core/field_setter.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "pongsim/messages/field_path.hh"

namespace pongsim::python {

using google::protobuf::FieldDescriptor;

namespace {

/// @return The nearest integer of the type.
template <class Whole>
Whole whole(double number) {
  using Limits = std::numeric_limits<Whole>;
  if (number <= static_cast<double>(Limits::lowest())) return Limits::lowest();
  if (number >= static_cast<double>(Limits::max())) return Limits::max();
  return static_cast<Whole>(std::round(number));
}

}  // namespace

FieldSetter::FieldSetter(const std::string& type, const std::string& path) {
  MessageError error;
  const auto known = FieldPath::parse(type, path, error);
  if (!known) {
    throw pybind11::value_error("field '" + path + "' of " + type + ": " + error.message +
                                (error.hint.empty() ? "" : "; " + error.hint));
  }
  if (!known->isNumber() || path.find('[') != std::string::npos) {
    throw pybind11::value_error("field '" + path + "' of " + type + " is not a single number");
  }
  const MessagePointer message = newMessage(type);
  const google::protobuf::Descriptor* at = message->GetDescriptor();
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    way_.push_back(at->FindFieldByName(path.substr(begin, end - begin)));
    at = way_.back()->message_type();
    begin = end + 1;
  }
}

void FieldSetter::set(Message& message, double number) const {
  Message* at = &message;
  for (std::size_t i = 0; i + 1 < way_.size(); ++i) at = at->GetReflection()->MutableMessage(at, way_[i]);
  const auto& reflection = *at->GetReflection();
  const FieldDescriptor* field = way_.back();
  switch (field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return reflection.SetDouble(at, field, number);
    case FieldDescriptor::CPPTYPE_FLOAT:
      return reflection.SetFloat(at, field, static_cast<float>(number));
    case FieldDescriptor::CPPTYPE_BOOL:
      return reflection.SetBool(at, field, number >= 0.5);
    case FieldDescriptor::CPPTYPE_INT32:
      return reflection.SetInt32(at, field, whole<std::int32_t>(number));
    case FieldDescriptor::CPPTYPE_UINT32:
      return reflection.SetUInt32(at, field, whole<std::uint32_t>(number));
    case FieldDescriptor::CPPTYPE_INT64:
      return reflection.SetInt64(at, field, whole<std::int64_t>(number));
    default:
      return reflection.SetUInt64(at, field, whole<std::uint64_t>(number));
  }
}

}  // namespace pongsim::python
