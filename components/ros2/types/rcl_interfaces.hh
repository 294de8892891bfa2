#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ros2/types/builtin_interfaces.hh"

namespace pongsim::ros2::rcl_interfaces {

struct Log {
  static constexpr const char* kName = "rcl_interfaces/msg/Log";
  static constexpr std::uint8_t kDebug = 10;
  static constexpr std::uint8_t kInfo = 20;
  static constexpr std::uint8_t kWarn = 30;
  static constexpr std::uint8_t kError = 40;
  static constexpr std::uint8_t kFatal = 50;
  builtin_interfaces::Time stamp;
  std::uint8_t level = 0;
  std::string name;
  std::string msg;
  std::string file;
  std::string function;
  std::uint32_t line = 0;
  static void visit(auto& self, auto&& field) {
    field("stamp", self.stamp);
    field("level", self.level);
    field("name", self.name);
    field("msg", self.msg);
    field("file", self.file);
    field("function", self.function);
    field("line", self.line);
  }
  bool operator==(const Log&) const = default;
};

struct ParameterValue {
  static constexpr const char* kName = "rcl_interfaces/msg/ParameterValue";
  std::uint8_t type = 0;
  bool bool_value = false;
  std::int64_t integer_value = 0;
  double double_value = 0;
  std::string string_value;
  std::vector<std::byte> byte_array_value;
  std::vector<bool> bool_array_value;
  std::vector<std::int64_t> integer_array_value;
  std::vector<double> double_array_value;
  std::vector<std::string> string_array_value;
  static void visit(auto& self, auto&& field) {
    field("type", self.type);
    field("bool_value", self.bool_value);
    field("integer_value", self.integer_value);
    field("double_value", self.double_value);
    field("string_value", self.string_value);
    field("byte_array_value", self.byte_array_value);
    field("bool_array_value", self.bool_array_value);
    field("integer_array_value", self.integer_array_value);
    field("double_array_value", self.double_array_value);
    field("string_array_value", self.string_array_value);
  }
  bool operator==(const ParameterValue&) const = default;
};

struct Parameter {
  static constexpr const char* kName = "rcl_interfaces/msg/Parameter";
  std::string name;
  ParameterValue value;
  static void visit(auto& self, auto&& field) {
    field("name", self.name);
    field("value", self.value);
  }
  bool operator==(const Parameter&) const = default;
};

struct FloatingPointRange {
  static constexpr const char* kName = "rcl_interfaces/msg/FloatingPointRange";
  double from_value = 0;
  double to_value = 0;
  double step = 0;
  static void visit(auto& self, auto&& field) {
    field("from_value", self.from_value);
    field("to_value", self.to_value);
    field("step", self.step);
  }
  bool operator==(const FloatingPointRange&) const = default;
};

struct IntegerRange {
  static constexpr const char* kName = "rcl_interfaces/msg/IntegerRange";
  std::int64_t from_value = 0;
  std::int64_t to_value = 0;
  std::uint64_t step = 0;
  static void visit(auto& self, auto&& field) {
    field("from_value", self.from_value);
    field("to_value", self.to_value);
    field("step", self.step);
  }
  bool operator==(const IntegerRange&) const = default;
};

struct ParameterDescriptor {
  static constexpr const char* kName = "rcl_interfaces/msg/ParameterDescriptor";
  std::string name;
  std::uint8_t type = 0;
  std::string description;
  std::string additional_constraints;
  bool read_only = false;
  bool dynamic_typing = false;
  BoundedList<FloatingPointRange, 1> floating_point_range;
  BoundedList<IntegerRange, 1> integer_range;
  static void visit(auto& self, auto&& field) {
    field("name", self.name);
    field("type", self.type);
    field("description", self.description);
    field("additional_constraints", self.additional_constraints);
    field("read_only", self.read_only);
    field("dynamic_typing", self.dynamic_typing);
    field("floating_point_range", self.floating_point_range);
    field("integer_range", self.integer_range);
  }
  bool operator==(const ParameterDescriptor&) const = default;
};

struct ParameterEvent {
  static constexpr const char* kName = "rcl_interfaces/msg/ParameterEvent";
  builtin_interfaces::Time stamp;
  std::string node;
  std::vector<Parameter> new_parameters;
  std::vector<Parameter> changed_parameters;
  std::vector<Parameter> deleted_parameters;
  static void visit(auto& self, auto&& field) {
    field("stamp", self.stamp);
    field("node", self.node);
    field("new_parameters", self.new_parameters);
    field("changed_parameters", self.changed_parameters);
    field("deleted_parameters", self.deleted_parameters);
  }
  bool operator==(const ParameterEvent&) const = default;
};

struct ParameterType {
  static constexpr const char* kName = "rcl_interfaces/msg/ParameterType";
  static constexpr std::uint8_t kParameterNotSet = 0;
  static constexpr std::uint8_t kParameterBool = 1;
  static constexpr std::uint8_t kParameterInteger = 2;
  static constexpr std::uint8_t kParameterDouble = 3;
  static constexpr std::uint8_t kParameterString = 4;
  static constexpr std::uint8_t kParameterByteArray = 5;
  static constexpr std::uint8_t kParameterBoolArray = 6;
  static constexpr std::uint8_t kParameterIntegerArray = 7;
  static constexpr std::uint8_t kParameterDoubleArray = 8;
  static constexpr std::uint8_t kParameterStringArray = 9;
  static void visit(auto&, auto&&) {}
  bool operator==(const ParameterType&) const = default;
};

struct ListParametersResult {
  static constexpr const char* kName = "rcl_interfaces/msg/ListParametersResult";
  std::vector<std::string> names;
  std::vector<std::string> prefixes;
  static void visit(auto& self, auto&& field) {
    field("names", self.names);
    field("prefixes", self.prefixes);
  }
  bool operator==(const ListParametersResult&) const = default;
};

struct SetParametersResult {
  static constexpr const char* kName = "rcl_interfaces/msg/SetParametersResult";
  bool successful = false;
  std::string reason;
  static void visit(auto& self, auto&& field) {
    field("successful", self.successful);
    field("reason", self.reason);
  }
  bool operator==(const SetParametersResult&) const = default;
};

namespace srv {

struct DescribeParameters {
  static constexpr const char* kName = "rcl_interfaces/srv/DescribeParameters";
  struct Request {
    static constexpr const char* kName = "rcl_interfaces/srv/DescribeParameters_Request";
    std::vector<std::string> names;
    static void visit(auto& self, auto&& field) { field("names", self.names); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "rcl_interfaces/srv/DescribeParameters_Response";
    std::vector<rcl_interfaces::ParameterDescriptor> descriptors;
    static void visit(auto& self, auto&& field) { field("descriptors", self.descriptors); }
    bool operator==(const Response&) const = default;
  };
};

struct GetParameterTypes {
  static constexpr const char* kName = "rcl_interfaces/srv/GetParameterTypes";
  struct Request {
    static constexpr const char* kName = "rcl_interfaces/srv/GetParameterTypes_Request";
    std::vector<std::string> names;
    static void visit(auto& self, auto&& field) { field("names", self.names); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "rcl_interfaces/srv/GetParameterTypes_Response";
    std::vector<std::uint8_t> types;
    static void visit(auto& self, auto&& field) { field("types", self.types); }
    bool operator==(const Response&) const = default;
  };
};

struct GetParameters {
  static constexpr const char* kName = "rcl_interfaces/srv/GetParameters";
  struct Request {
    static constexpr const char* kName = "rcl_interfaces/srv/GetParameters_Request";
    std::vector<std::string> names;
    static void visit(auto& self, auto&& field) { field("names", self.names); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "rcl_interfaces/srv/GetParameters_Response";
    std::vector<rcl_interfaces::ParameterValue> values;
    static void visit(auto& self, auto&& field) { field("values", self.values); }
    bool operator==(const Response&) const = default;
  };
};

struct ListParameters {
  static constexpr const char* kName = "rcl_interfaces/srv/ListParameters";
  struct Request {
    static constexpr const char* kName = "rcl_interfaces/srv/ListParameters_Request";
    static constexpr std::uint64_t kDepthRecursive = 0;
    std::vector<std::string> prefixes;
    std::uint64_t depth = 0;
    static void visit(auto& self, auto&& field) {
      field("prefixes", self.prefixes);
      field("depth", self.depth);
    }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "rcl_interfaces/srv/ListParameters_Response";
    rcl_interfaces::ListParametersResult result;
    static void visit(auto& self, auto&& field) { field("result", self.result); }
    bool operator==(const Response&) const = default;
  };
};

struct SetParameters {
  static constexpr const char* kName = "rcl_interfaces/srv/SetParameters";
  struct Request {
    static constexpr const char* kName = "rcl_interfaces/srv/SetParameters_Request";
    std::vector<rcl_interfaces::Parameter> parameters;
    static void visit(auto& self, auto&& field) { field("parameters", self.parameters); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "rcl_interfaces/srv/SetParameters_Response";
    std::vector<rcl_interfaces::SetParametersResult> results;
    static void visit(auto& self, auto&& field) { field("results", self.results); }
    bool operator==(const Response&) const = default;
  };
};

struct SetParametersAtomically {
  static constexpr const char* kName = "rcl_interfaces/srv/SetParametersAtomically";
  struct Request {
    static constexpr const char* kName = "rcl_interfaces/srv/SetParametersAtomically_Request";
    std::vector<rcl_interfaces::Parameter> parameters;
    static void visit(auto& self, auto&& field) { field("parameters", self.parameters); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "rcl_interfaces/srv/SetParametersAtomically_Response";
    rcl_interfaces::SetParametersResult result;
    static void visit(auto& self, auto&& field) { field("result", self.result); }
    bool operator==(const Response&) const = default;
  };
};

}  // namespace srv

}  // namespace pongsim::ros2::rcl_interfaces
