#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ros2/types/reflection.hh"

namespace pongsim::ros2::type_description_interfaces {

struct FieldType {
  static constexpr const char* kName = "type_description_interfaces/msg/FieldType";
  std::uint8_t type_id = 0;
  std::uint64_t capacity = 0;
  std::uint64_t string_capacity = 0;
  BoundedString<255> nested_type_name;
  static void visit(auto& self, auto&& field) {
    field("type_id", self.type_id);
    field("capacity", self.capacity);
    field("string_capacity", self.string_capacity);
    field("nested_type_name", self.nested_type_name);
  }
  bool operator==(const FieldType&) const = default;
};

struct Field {
  static constexpr const char* kName = "type_description_interfaces/msg/Field";
  std::string name;
  FieldType type;
  std::string default_value;
  static void visit(auto& self, auto&& field) {
    field("name", self.name);
    field("type", self.type);
    field("default_value", self.default_value);
  }
  bool operator==(const Field&) const = default;
};

struct IndividualTypeDescription {
  static constexpr const char* kName = "type_description_interfaces/msg/IndividualTypeDescription";
  BoundedString<255> type_name;
  std::vector<Field> fields;
  static void visit(auto& self, auto&& field) {
    field("type_name", self.type_name);
    field("fields", self.fields);
  }
  bool operator==(const IndividualTypeDescription&) const = default;
};

struct TypeDescription {
  static constexpr const char* kName = "type_description_interfaces/msg/TypeDescription";
  IndividualTypeDescription type_description;
  std::vector<IndividualTypeDescription> referenced_type_descriptions;
  static void visit(auto& self, auto&& field) {
    field("type_description", self.type_description);
    field("referenced_type_descriptions", self.referenced_type_descriptions);
  }
  bool operator==(const TypeDescription&) const = default;
};

struct TypeSource {
  static constexpr const char* kName = "type_description_interfaces/msg/TypeSource";
  std::string type_name;
  std::string encoding;
  std::string raw_file_contents;
  static void visit(auto& self, auto&& field) {
    field("type_name", self.type_name);
    field("encoding", self.encoding);
    field("raw_file_contents", self.raw_file_contents);
  }
  bool operator==(const TypeSource&) const = default;
};

struct KeyValue {
  static constexpr const char* kName = "type_description_interfaces/msg/KeyValue";
  std::string key;
  std::string value;
  static void visit(auto& self, auto&& field) {
    field("key", self.key);
    field("value", self.value);
  }
  bool operator==(const KeyValue&) const = default;
};

namespace srv {

struct GetTypeDescription {
  static constexpr const char* kName = "type_description_interfaces/srv/GetTypeDescription";
  struct Request {
    static constexpr const char* kName = "type_description_interfaces/srv/GetTypeDescription_Request";
    std::string type_name;
    std::string type_hash;
    bool include_type_sources = true;
    static void visit(auto& self, auto&& field) {
      field("type_name", self.type_name);
      field("type_hash", self.type_hash);
      field("include_type_sources", self.include_type_sources);
    }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "type_description_interfaces/srv/GetTypeDescription_Response";
    bool successful = false;
    std::string failure_reason;
    TypeDescription type_description;
    std::vector<TypeSource> type_sources;
    std::vector<KeyValue> extra_information;
    static void visit(auto& self, auto&& field) {
      field("successful", self.successful);
      field("failure_reason", self.failure_reason);
      field("type_description", self.type_description);
      field("type_sources", self.type_sources);
      field("extra_information", self.extra_information);
    }
    bool operator==(const Response&) const = default;
  };
};

}  // namespace srv

}  // namespace pongsim::ros2::type_description_interfaces
