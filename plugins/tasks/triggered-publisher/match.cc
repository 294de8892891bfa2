#include "match.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <google/protobuf/util/message_differencer.h>

#include <cmath>
#include <limits>

#include "pongsim/parameters.hh"

namespace pongsim {

namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::util::DefaultFieldComparator;
using google::protobuf::util::MessageDifferencer;

std::string fieldNames(const Descriptor& type) {
  std::string names;
  for (int i = 0; i < type.field_count(); ++i) names += (i > 0 ? ", " : "") + type.field(i)->name();
  return names;
}

/// @return The text that sets the field at the end of `path` to `value`, in protobuf's text format.
std::string nestedText(const std::vector<const FieldDescriptor*>& path, const std::string& value) {
  std::string text;
  for (const FieldDescriptor* field : path) {
    text += field->name() + (field == path.back() ? ": " : " {");
  }
  const FieldDescriptor& last = *path.back();
  const bool isMessage = last.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
  const bool isBare = last.cpp_type() == FieldDescriptor::CPPTYPE_STRING && value.find_first_of("\"'") != 0;
  const bool needsBraces = isMessage && !value.starts_with('{');
  const std::string open = needsBraces ? "{" : isBare ? "\"" : "";
  const std::string close = needsBraces ? "}" : isBare ? "\"" : "";
  text += open + value + close + std::string(path.size() - 1, '}');
  return text;
}

/// Configures `differencer` with the tolerance and rules of a match.
void setUp(MessageDifferencer& differencer, DefaultFieldComparator& comparator, double tolerance) {
  comparator.set_float_comparison(DefaultFieldComparator::APPROXIMATE);
  comparator.set_treat_nan_as_equal(true);
  comparator.SetDefaultFractionAndMargin(std::numeric_limits<double>::min(), tolerance);
  differencer.set_field_comparator(&comparator);
  differencer.set_message_field_comparison(MessageDifferencer::EQUIVALENT);
}

}  // namespace

Match::Match(const Element& element, const std::string& type) : wanted_(newMessage(type)) {
  const std::string tolerance = element.attributeOr("tol", "1e-8");
  try {
    Element value;
    value.name = "match tol";
    value.text = tolerance;
    value.position = element.position;
    tolerance_ = value.as<double>();
  } catch (const Error&) {
    tolerance_ = -1;
  }
  if (!(tolerance_ >= 0)) refuse(element, "the 'tol' of a <match> must be zero or more, not '" + tolerance + "'");

  const std::string logic = element.attributeOr("logic_type", "positive");
  if (logic != "positive" && logic != "negative") {
    refuse(element, "the 'logic_type' of a <match> is '" + logic + "'", "it can be 'positive' or 'negative'");
  }
  negative_ = logic == "negative";

  std::string text = element.text;
  if (const Element::Attribute* field = element.attribute("field")) {
    findField(element, field->value);
    text = nestedText(path_, text);
  }
  if (const std::optional<MessageError> error = parseMessage(text, *wanted_)) {
    refuse(element,
           "the text of this <match> is not " +
               (path_.empty() ? "of type " + type : "a value of '" + path_.back()->full_name() + "'") + ": " +
               error->message,
           error->hint);
  }
}

Match::Match(Match&&) noexcept = default;

Match::~Match() = default;

void Match::findField(const Element& element, std::string_view path) {
  const Descriptor* type = wanted_->GetDescriptor();
  while (true) {
    const std::size_t end = std::min(path.find('.'), path.size());
    const std::string name(path.substr(0, end));
    if (type == nullptr)
      refuse(element, "'" + path_.back()->full_name() + "' has no field '" + name + "': it is not a message");
    const FieldDescriptor* field = type->FindFieldByName(name);
    if (field == nullptr) {
      refuse(element, "field '" + name + "' is not in " + type->full_name(), "its fields are " + fieldNames(*type));
    }
    path_.push_back(field);
    if (end == path.size()) return;
    if (field->is_repeated()) {
      refuse(element, "field '" + name + "' of a <match> is repeated: only the last field of a path may be");
    }
    type = field->message_type();
    path.remove_prefix(end + 1);
  }
}

bool Match::matches(const Message& message) const {
  DefaultFieldComparator comparator;
  MessageDifferencer differencer;
  setUp(differencer, comparator, tolerance_);
  if (path_.empty()) return differencer.Compare(*wanted_, message) != negative_;

  const Message* wanted = wanted_.get();
  const Message* found = &message;
  for (const FieldDescriptor* field : path_) {
    if (field == path_.back()) break;
    wanted = &wanted->GetReflection()->GetMessage(*wanted, field);
    found = &found->GetReflection()->GetMessage(*found, field);
  }
  const FieldDescriptor* last = path_.back();
  if (last->is_repeated()) {
    // PARTIAL and AS_SET: each given value equals one of those in the message.
    differencer.set_scope(MessageDifferencer::PARTIAL);
    differencer.set_repeated_field_comparison(MessageDifferencer::AS_SET);
    differencer.set_message_field_comparison(MessageDifferencer::EQUAL);
  }
  return differencer.CompareWithFields(*wanted, *found, {last}, {last}) != negative_;
}

}  // namespace pongsim
