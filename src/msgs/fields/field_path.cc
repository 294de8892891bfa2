#include "pongsim/messages/field_path.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <google/protobuf/text_format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "base/nearest_word.hh"

namespace pongsim {

namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Reflection;
using google::protobuf::TextFormat;

constexpr int kMostFields = 100'000;

/// A name in a path, with its index in brackets.
struct Word {
  std::string_view name;
  std::optional<std::string_view> index;
};

Word split(std::string_view word) {
  const std::size_t open = word.find('[');
  if (open == std::string_view::npos || !word.ends_with(']')) return {word, {}};
  return {word.substr(0, open), word.substr(open + 1, word.size() - open - 2)};
}

std::string nearField(std::string_view name, const Descriptor& type) {
  std::vector<std::string_view> names;
  for (int i = 0; i < type.field_count(); ++i) names.push_back(type.field(i)->name());
  return base::didYouMean(name, names);
}

const Descriptor* descriptorOf(const std::string& type) {
  const MessagePointer message = newMessage(type);
  return message ? message->GetDescriptor() : nullptr;
}

/// @param index Index in a list; negative: not a list.
std::string valueText(const Message& owner, const FieldDescriptor& field, int index) {
  const Reflection& reflection = *owner.GetReflection();
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_STRING && field.type() != FieldDescriptor::TYPE_BYTES) {
    std::string scratch;
    return index < 0 ? reflection.GetStringReference(owner, &field, &scratch)
                     : reflection.GetRepeatedStringReference(owner, &field, index, &scratch);
  }
  TextFormat::Printer printer;
  printer.SetSingleLineMode(true);
  std::string text;
  printer.PrintFieldValueToString(owner, &field, index, &text);
  if (text.ends_with(' ')) text.pop_back();
  return field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE ? "{" + text + "}" : text;
}

double numberAt(const Message& owner, const FieldDescriptor& field, int index) {
  // every kind of number is printed so that it reads back as the same value; this is rare enough not to need speed
  const std::string text = valueText(owner, field, index);
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_BOOL) return text == "true" ? 1 : 0;
  double value = std::numeric_limits<double>::quiet_NaN();
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

bool hasNumbers(const FieldDescriptor& field) {
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_STRING:
    case FieldDescriptor::CPPTYPE_MESSAGE:
    case FieldDescriptor::CPPTYPE_ENUM:
      return false;
    default:
      return true;
  }
}

/// @param budget Maximum number of fields to visit, because a made-up type can have more of them than there is time
/// for.
void addScalarPaths(const Descriptor& type, const std::string& prefix, std::vector<const Descriptor*>& open,
                    int& budget, std::vector<std::string>& paths) {
  // a type that contains itself has no end
  if (std::find(open.begin(), open.end(), &type) != open.end()) return;
  open.push_back(&type);
  for (int i = 0; i < type.field_count(); ++i) {
    const FieldDescriptor& field = *type.field(i);
    // Fortress leaves the headers of inner messages empty
    const bool isInnerHeader = !prefix.empty() && field.name() == "header";
    if (field.is_repeated() || isInnerHeader) continue;
    if (--budget < 0) break;
    const std::string path = prefix + field.name();
    if (field.message_type() != nullptr) {
      addScalarPaths(*field.message_type(), path + ".", open, budget, paths);
    } else {
      paths.push_back(path);
    }
  }
  open.pop_back();
}

}  // namespace

std::optional<FieldPath> FieldPath::parse(const std::string& type, std::string_view path, MessageError& error) {
  if (const Descriptor* descriptor = descriptorOf(type)) return parse(*descriptor, path, error);
  error = {1, 1, "unknown message type '" + type + "'", ""};
  return std::nullopt;
}

std::optional<FieldPath> FieldPath::parse(const Descriptor& type, std::string_view path, MessageError& error) {
  FieldPath result;
  result.text_ = path;
  const Descriptor* owner = &type;
  std::size_t begin = 0;
  const auto refuse = [&](std::string message, std::string hint = {}) {
    error = {1, static_cast<int>(begin) + 1, std::move(message), std::move(hint)};
    return std::nullopt;
  };
  for (bool isLast = false; !isLast;) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    isLast = end == path.size();
    const Word word = split(path.substr(begin, end - begin));
    const std::string quoted = "'" + std::string(word.name) + "'";
    if (owner == nullptr) return refuse("there is no " + quoted + " in " + result.steps_.back().field->full_name());
    const FieldDescriptor* field = owner->FindFieldByName(std::string(word.name));
    if (field == nullptr) {
      return refuse("field " + quoted + " is not in " + owner->full_name(), nearField(word.name, *owner));
    }
    Step step{field};
    if (word.index) {
      const char* const last = word.index->data() + word.index->size();
      const auto [stopped, fault] = std::from_chars(word.index->data(), last, step.index);
      if (!field->is_repeated()) return refuse("field " + quoted + " is not a list");
      if (fault != std::errc() || stopped != last || step.index < 0) {
        return refuse("'" + std::string(*word.index) + "' is not an index of the list " + quoted, "the first is [0]");
      }
    } else if (field->is_repeated() && !isLast) {
      return refuse("field " + quoted + " is a list", "say which: " + std::string(word.name) + "[0]");
    }
    result.steps_.push_back(step);
    owner = field->message_type();
    begin = end + 1;
  }
  return result;
}

bool FieldPath::isNumber() const {
  const Step& last = steps_.back();
  return hasNumbers(*last.field) && (!last.field->is_repeated() || last.index >= 0);
}

bool FieldPath::isNumberList() const {
  const Step& last = steps_.back();
  return hasNumbers(*last.field) && last.field->is_repeated() && last.index < 0;
}

const Message* FieldPath::ownerIn(const Message& message) const {
  const Message* owner = &message;
  for (const Step& step : steps_) {
    const Reflection& reflection = *owner->GetReflection();
    if (step.index >= 0 && step.index >= reflection.FieldSize(*owner, step.field)) return nullptr;
    if (&step == &steps_.back()) break;
    owner = step.index < 0 ? &reflection.GetMessage(*owner, step.field)
                           : &reflection.GetRepeatedMessage(*owner, step.field, step.index);
  }
  return owner;
}

std::optional<double> FieldPath::numberIn(const Message& message) const {
  const Message* owner = ownerIn(message);
  if (owner == nullptr) return std::nullopt;
  return numberAt(*owner, *steps_.back().field, steps_.back().index);
}

std::vector<double> FieldPath::numbersIn(const Message& message) const {
  const Message* owner = ownerIn(message);
  if (owner == nullptr) return {};
  const FieldDescriptor& field = *steps_.back().field;
  const Reflection& reflection = *owner->GetReflection();
  const int size = reflection.FieldSize(*owner, &field);
  std::vector<double> numbers;
  numbers.reserve(static_cast<std::size_t>(size));
  // the ranges of a lidar: hundreds in each message
  const bool isDouble = field.cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE;
  for (int i = 0; i < size; ++i) {
    numbers.push_back(isDouble ? reflection.GetRepeatedDouble(*owner, &field, i) : numberAt(*owner, field, i));
  }
  return numbers;
}

std::optional<std::string> FieldPath::valueIn(const Message& message) const {
  const Message* owner = ownerIn(message);
  if (owner == nullptr) return std::nullopt;
  const Step& last = steps_.back();
  if (!last.field->is_repeated() || last.index >= 0) return valueText(*owner, *last.field, last.index);
  std::string list;
  for (int i = 0; i < owner->GetReflection()->FieldSize(*owner, last.field); ++i) {
    list += (i > 0 ? ", " : "") + valueText(*owner, *last.field, i);
  }
  return "[" + list + "]";
}

std::vector<std::string> scalarPaths(const Descriptor& type) {
  std::vector<std::string> paths;
  std::vector<const Descriptor*> open;
  int budget = kMostFields;
  addScalarPaths(type, "", open, budget, paths);
  return paths;
}

std::vector<std::string> scalarPaths(const std::string& type) {
  const Descriptor* descriptor = descriptorOf(type);
  return descriptor == nullptr ? std::vector<std::string>() : scalarPaths(*descriptor);
}

}  // namespace pongsim
