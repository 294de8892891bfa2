#include "core/message_dict.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/message.h>

#include <cstdint>
#include <set>
#include <string_view>
#include <vector>

#include "pongsim/program/nearest_word.hh"

namespace pongsim::python {

namespace {

using google::protobuf::Descriptor;
using google::protobuf::EnumValueDescriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::FileDescriptor;
using google::protobuf::Reflection;

py::object textOf(const FieldDescriptor& field, const std::string& text) {
  if (field.type() == FieldDescriptor::TYPE_BYTES) return py::bytes(text);
  // of other processes the text may not be UTF-8: invalid bytes are replaced
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
}

py::object enumOf(const FieldDescriptor& field, int number) {
  const EnumValueDescriptor* value = field.enum_type()->FindValueByNumber(number);
  if (value == nullptr) return py::int_(number);
  return py::str(value->name());
}

py::object single(const Message& message, const Reflection& reflection, const FieldDescriptor& field) {
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      return py::int_(reflection.GetInt32(message, &field));
    case FieldDescriptor::CPPTYPE_INT64:
      return py::int_(reflection.GetInt64(message, &field));
    case FieldDescriptor::CPPTYPE_UINT32:
      return py::int_(reflection.GetUInt32(message, &field));
    case FieldDescriptor::CPPTYPE_UINT64:
      return py::int_(reflection.GetUInt64(message, &field));
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return py::float_(reflection.GetDouble(message, &field));
    case FieldDescriptor::CPPTYPE_FLOAT:
      return py::float_(static_cast<double>(reflection.GetFloat(message, &field)));
    case FieldDescriptor::CPPTYPE_BOOL:
      return py::bool_(reflection.GetBool(message, &field));
    case FieldDescriptor::CPPTYPE_ENUM:
      return enumOf(field, reflection.GetEnumValue(message, &field));
    case FieldDescriptor::CPPTYPE_STRING:
      return textOf(field, reflection.GetString(message, &field));
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return dictOf(reflection.GetMessage(message, &field));
  }
  return py::none();
}

py::object element(const Message& message, const Reflection& reflection, const FieldDescriptor& field, int i) {
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      return py::int_(reflection.GetRepeatedInt32(message, &field, i));
    case FieldDescriptor::CPPTYPE_INT64:
      return py::int_(reflection.GetRepeatedInt64(message, &field, i));
    case FieldDescriptor::CPPTYPE_UINT32:
      return py::int_(reflection.GetRepeatedUInt32(message, &field, i));
    case FieldDescriptor::CPPTYPE_UINT64:
      return py::int_(reflection.GetRepeatedUInt64(message, &field, i));
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return py::float_(reflection.GetRepeatedDouble(message, &field, i));
    case FieldDescriptor::CPPTYPE_FLOAT:
      return py::float_(static_cast<double>(reflection.GetRepeatedFloat(message, &field, i)));
    case FieldDescriptor::CPPTYPE_BOOL:
      return py::bool_(reflection.GetRepeatedBool(message, &field, i));
    case FieldDescriptor::CPPTYPE_ENUM:
      return enumOf(field, reflection.GetRepeatedEnumValue(message, &field, i));
    case FieldDescriptor::CPPTYPE_STRING:
      return textOf(field, reflection.GetRepeatedString(message, &field, i));
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return dictOf(reflection.GetRepeatedMessage(message, &field, i));
  }
  return py::none();
}

/// Fills a message from Python objects. Keeps the current path, such as "pose.position.x", for error messages.
class Filler {
 public:
  void fill(Message& message, py::handle from) {
    if (!PyDict_Check(from.ptr())) {
      wrongType("a dict of the fields of " + message.GetDescriptor()->name(), from);
    }
    for (const auto& [key, value] : py::reinterpret_borrow<py::dict>(from)) {
      if (!PyUnicode_Check(key.ptr())) throw py::type_error("names of fields must be strings" + where());
      const auto name = key.cast<std::string>();
      const FieldDescriptor* field = message.GetDescriptor()->FindFieldByName(name);
      if (field == nullptr) unknownField(*message.GetDescriptor(), name);
      if (value.is_none()) continue;
      path_.push_back(name);
      if (field->is_repeated()) {
        fillList(message, *field, value);
      } else {
        set(message, *field, value, false);
      }
      path_.pop_back();
    }
  }

 private:
  std::string path() const {
    std::string text;
    for (const std::string& part : path_) text += (text.empty() || part.front() == '[' ? "" : ".") + part;
    return text;
  }
  std::string where() const { return path_.empty() ? std::string() : " (field '" + path() + "')"; }

  [[noreturn]] void wrongType(const std::string& wanted, py::handle got) const {
    throw py::type_error((path_.empty() ? "the message" : "field '" + path() + "'") + " must be " + wanted + ", not " +
                         std::string(Py_TYPE(got.ptr())->tp_name));
  }

  [[noreturn]] void unknownField(const Descriptor& type, const std::string& name) const {
    std::vector<std::string_view> names;
    for (int i = 0; i < type.field_count(); ++i) names.push_back(type.field(i)->name());
    const std::string_view nearest = nearestWord(name, names);
    throw py::value_error(type.full_name() + " has no field '" + name + "'" + where() +
                          (nearest.empty() ? "" : "; did you mean '" + std::string(nearest) + "'?"));
  }

  void fillList(Message& message, const FieldDescriptor& field, py::handle values) {
    if (PyUnicode_Check(values.ptr()) || PyBytes_Check(values.ptr()) || PyDict_Check(values.ptr())) {
      wrongType("a list", values);
    }
    const auto iterator = py::reinterpret_steal<py::object>(PyObject_GetIter(values.ptr()));
    if (!iterator) {
      PyErr_Clear();
      wrongType("a list", values);
    }
    std::size_t i = 0;
    for (const py::handle value : py::reinterpret_borrow<py::iterator>(iterator)) {
      path_.push_back("[" + std::to_string(i++) + "]");
      set(message, field, value, true);
      path_.pop_back();
    }
  }

  long long signedNumber(py::handle value, long long lowest, long long highest) const {
    const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
    if (!index) {
      PyErr_Clear();
      wrongType("a whole number", value);
    }
    int overflow = 0;
    const long long number = PyLong_AsLongLongAndOverflow(index.ptr(), &overflow);
    if (overflow != 0 || number < lowest || number > highest) {
      throw py::value_error("field '" + path() + "' is out of range: " + py::str(value).cast<std::string>() +
                            "; it goes from " + std::to_string(lowest) + " to " + std::to_string(highest));
    }
    return number;
  }
  std::uint64_t unsignedNumber(py::handle value) const {
    const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
    if (!index) {
      PyErr_Clear();
      wrongType("a whole number", value);
    }
    const unsigned long long number = PyLong_AsUnsignedLongLong(index.ptr());
    if (PyErr_Occurred() != nullptr) {
      PyErr_Clear();
      throw py::value_error("field '" + path() + "' is out of range: " + py::str(value).cast<std::string>() +
                            "; it goes from 0 to " + std::to_string(UINT64_MAX));
    }
    return number;
  }
  double real(py::handle value) const {
    const double number = PyUnicode_Check(value.ptr()) ? -1 : PyFloat_AsDouble(value.ptr());
    if (PyUnicode_Check(value.ptr()) || PyErr_Occurred() != nullptr) {
      PyErr_Clear();
      wrongType("a number", value);
    }
    return number;
  }
  bool truth(py::handle value) const {
    const int result = PyUnicode_Check(value.ptr()) ? -1 : PyObject_IsTrue(value.ptr());
    if (result < 0) {
      PyErr_Clear();
      wrongType("True or False", value);
    }
    return result == 1;
  }
  std::string text(py::handle value, bool isBytes) const {
    if (isBytes) {
      char* data = nullptr;
      Py_ssize_t size = 0;
      const auto bytes = py::reinterpret_steal<py::object>(
          PyObject_CheckBuffer(value.ptr()) != 0 ? PyBytes_FromObject(value.ptr()) : nullptr);
      if (!bytes || PyBytes_AsStringAndSize(bytes.ptr(), &data, &size) != 0) {
        PyErr_Clear();
        wrongType("bytes", value);
      }
      return {data, static_cast<std::size_t>(size)};
    }
    if (!PyUnicode_Check(value.ptr())) wrongType("a text", value);
    return value.cast<std::string>();
  }
  int enumerator(const FieldDescriptor& field, py::handle value) const {
    if (!PyUnicode_Check(value.ptr())) return static_cast<int>(signedNumber(value, INT32_MIN, INT32_MAX));
    const auto name = value.cast<std::string>();
    if (const EnumValueDescriptor* found = field.enum_type()->FindValueByName(name)) return found->number();
    std::string known;
    for (int i = 0; i < field.enum_type()->value_count(); ++i) {
      known += (i == 0 ? "" : ", ") + field.enum_type()->value(i)->name();
    }
    throw py::value_error("field '" + path() + "' has no value '" + name + "': " + known);
  }

  void set(Message& message, const FieldDescriptor& field, py::handle value, bool adds) {
    const Reflection& reflection = *message.GetReflection();
    switch (field.cpp_type()) {
      case FieldDescriptor::CPPTYPE_INT32: {
        const auto number = static_cast<std::int32_t>(signedNumber(value, INT32_MIN, INT32_MAX));
        adds ? reflection.AddInt32(&message, &field, number) : reflection.SetInt32(&message, &field, number);
        return;
      }
      case FieldDescriptor::CPPTYPE_INT64: {
        const auto number = signedNumber(value, INT64_MIN, INT64_MAX);
        adds ? reflection.AddInt64(&message, &field, number) : reflection.SetInt64(&message, &field, number);
        return;
      }
      case FieldDescriptor::CPPTYPE_UINT32: {
        const auto number = static_cast<std::uint32_t>(signedNumber(value, 0, UINT32_MAX));
        adds ? reflection.AddUInt32(&message, &field, number) : reflection.SetUInt32(&message, &field, number);
        return;
      }
      case FieldDescriptor::CPPTYPE_UINT64: {
        const std::uint64_t number = unsignedNumber(value);
        adds ? reflection.AddUInt64(&message, &field, number) : reflection.SetUInt64(&message, &field, number);
        return;
      }
      case FieldDescriptor::CPPTYPE_DOUBLE:
        adds ? reflection.AddDouble(&message, &field, real(value))
             : reflection.SetDouble(&message, &field, real(value));
        return;
      case FieldDescriptor::CPPTYPE_FLOAT: {
        const auto number = static_cast<float>(real(value));
        adds ? reflection.AddFloat(&message, &field, number) : reflection.SetFloat(&message, &field, number);
        return;
      }
      case FieldDescriptor::CPPTYPE_BOOL:
        adds ? reflection.AddBool(&message, &field, truth(value)) : reflection.SetBool(&message, &field, truth(value));
        return;
      case FieldDescriptor::CPPTYPE_ENUM: {
        const int number = enumerator(field, value);
        adds ? reflection.AddEnumValue(&message, &field, number) : reflection.SetEnumValue(&message, &field, number);
        return;
      }
      case FieldDescriptor::CPPTYPE_STRING: {
        std::string content = text(value, field.type() == FieldDescriptor::TYPE_BYTES);
        adds ? reflection.AddString(&message, &field, std::move(content))
             : reflection.SetString(&message, &field, std::move(content));
        return;
      }
      case FieldDescriptor::CPPTYPE_MESSAGE:
        fill(adds ? *reflection.AddMessage(&message, &field) : *reflection.MutableMessage(&message, &field), value);
        return;
    }
  }

  std::vector<std::string> path_;
};

void addFile(const FileDescriptor& file, std::set<const FileDescriptor*>& known, py::list& files) {
  if (!known.insert(&file).second) return;
  for (int i = 0; i < file.dependency_count(); ++i) addFile(*file.dependency(i), known, files);
  google::protobuf::FileDescriptorProto proto;
  file.CopyTo(&proto);
  files.append(py::bytes(proto.SerializeAsString()));
}

void parse(Message& message, const char* data, std::size_t size) {
  if (!message.ParseFromArray(data, static_cast<int>(size))) {
    throw py::value_error("these bytes are not of type " + message.GetDescriptor()->full_name());
  }
}

}  // namespace

std::string knownType(const std::string& name) {
  if (auto known = messageTypeName(name)) return *known;
  const std::string nearest = nearestMessageType(name);
  throw py::value_error("there is no message type '" + name + "'" +
                        (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
}

py::dict dictOf(const Message& message) {
  py::dict result;
  const Descriptor& type = *message.GetDescriptor();
  const Reflection& reflection = *message.GetReflection();
  for (int i = 0; i < type.field_count(); ++i) {
    const FieldDescriptor& field = *type.field(i);
    const py::str name(field.name());
    if (field.is_repeated()) {
      py::list values;
      const int size = reflection.FieldSize(message, &field);
      for (int k = 0; k < size; ++k) values.append(element(message, reflection, field, k));
      result[name] = values;
    } else if (!field.has_presence() || reflection.HasField(message, &field)) {
      result[name] = single(message, reflection, field);
    }
  }
  return result;
}

std::string typeOfObject(py::handle object) {
  if (!py::hasattr(object, "DESCRIPTOR") || !py::hasattr(object, "SerializeToString")) return {};
  return object.attr("DESCRIPTOR").attr("full_name").cast<std::string>();
}

void fillIn(Message& message, py::handle from) {
  if (const std::string type = typeOfObject(from); !type.empty()) {
    if (messageTypeName(type) != message.GetDescriptor()->full_name()) {
      throw py::type_error("expected " + message.GetDescriptor()->full_name() + ", not " + type);
    }
    const auto bytes = from.attr("SerializeToString")().cast<std::string>();
    parse(message, bytes.data(), bytes.size());
  } else if (PyUnicode_Check(from.ptr())) {
    if (const auto error = parseMessage(from.cast<std::string>(), message)) {
      throw py::value_error(message.GetDescriptor()->full_name() + ", " + std::to_string(error->line) + ":" +
                            std::to_string(error->column) + ": " + error->message +
                            (error->hint.empty() ? "" : "; " + error->hint));
    }
  } else {
    Filler().fill(message, from);
  }
}

py::object messageAs(py::handle type, const std::string& name, std::span<const std::byte> bytes) {
  const char* data = reinterpret_cast<const char*>(bytes.data());
  if (!type || type.is_none()) {
    const MessagePointer message = newMessage(name);
    if (message == nullptr) throw py::value_error("there is no message type '" + name + "' here; ask for bytes");
    parse(*message, data, bytes.size());
    return dictOf(*message);
  }
  py::bytes content(data, bytes.size());
  if (type.ptr() == reinterpret_cast<PyObject*>(&PyBytes_Type)) return content;
  const auto wanted = type.attr("DESCRIPTOR").attr("full_name").cast<std::string>();
  if (messageTypeName(wanted) != name && wanted != name) {
    throw py::type_error("received " + name + ", but expected " + wanted);
  }
  return type.attr("FromString")(content);
}

py::list filesOf(const std::string& type) {
  py::list files;
  std::set<const FileDescriptor*> known;
  addFile(*newMessage(knownType(type))->GetDescriptor()->file(), known, files);
  return files;
}

}  // namespace pongsim::python
