#include "message_noise.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <cmath>
#include <string>
#include <vector>

namespace pongsim::faults {

namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Reflection;

double noisy(double number, double deviation, Random& random) {
  return std::isfinite(number) ? number + random.normal(0, deviation) : number;
}

void addTo(Message& message, const FieldDescriptor& field, int count, double deviation, Random& random) {
  const Reflection& reflection = *message.GetReflection();
  for (int i = 0; i < count; ++i) {
    if (field.cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE) {
      if (field.is_repeated()) {
        reflection.SetRepeatedDouble(&message, &field, i,
                                     noisy(reflection.GetRepeatedDouble(message, &field, i), deviation, random));
      } else {
        reflection.SetDouble(&message, &field, noisy(reflection.GetDouble(message, &field), deviation, random));
      }
    } else if (field.is_repeated()) {
      const double number = noisy(reflection.GetRepeatedFloat(message, &field, i), deviation, random);
      reflection.SetRepeatedFloat(&message, &field, i, static_cast<float>(number));
    } else {
      const double number = noisy(reflection.GetFloat(message, &field), deviation, random);
      reflection.SetFloat(&message, &field, static_cast<float>(number));
    }
  }
}

bool isNumber(const FieldDescriptor& field) {
  return field.cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE || field.cpp_type() == FieldDescriptor::CPPTYPE_FLOAT;
}

bool isMessage(const FieldDescriptor& field) { return field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE; }

}  // namespace

bool addNoise(Message& message, std::string_view field, double deviation, Random& random) {
  const Reflection& reflection = *message.GetReflection();
  const std::string_view first = field.substr(0, field.find('.'));
  const std::string_view rest = first.size() == field.size() ? "" : field.substr(first.size() + 1);
  bool isThere = field.empty();
  for (int number = 0; number < message.GetDescriptor()->field_count(); ++number) {
    const FieldDescriptor& each = *message.GetDescriptor()->field(number);
    const bool isNamed = !field.empty() && each.name() == first;
    if (!field.empty() ? !isNamed : each.name() == "header") continue;
    if (isNumber(each) && rest.empty()) {
      isThere = true;
      addTo(message, each, each.is_repeated() ? reflection.FieldSize(message, &each) : 1, deviation, random);
    } else if (isMessage(each)) {
      // without a rest, all of it
      isThere = isThere || rest.empty();
      const int count = each.is_repeated()                    ? reflection.FieldSize(message, &each)
                        : reflection.HasField(message, &each) ? 1
                                                              : 0;
      for (int i = 0; i < count; ++i) {
        Message& part = each.is_repeated() ? *reflection.MutableRepeatedMessage(&message, &each, i)
                                           : *reflection.MutableMessage(&message, &each);
        isThere = addNoise(part, rest, deviation, random) || isThere;
      }
      // where nothing is there to have it
      isThere = isThere || count == 0;
    }
  }
  return isThere;
}

}  // namespace pongsim::faults
