#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/element.hh"
#include "pongsim/message.hh"

namespace google::protobuf {
class FieldDescriptor;
}

namespace pongsim {

/// One `<match>` of a TriggeredPublisher: whether a message, or one field of it, equals the value in the world's file.
/// Fields missing in the text count as their defaults. Numbers are equal within the tolerance; a repeated field matches
/// if it contains each of the given values.
class Match {
 public:
  /// @param element The `<match>`: its text in protobuf's text format, or the value alone with a `field` attribute (a
  /// path such as `pose.position.x`); `tol`, 1e-8 if not given; `logic_type`, `positive` or `negative`.
  /// @param type Full name of the message type.
  /// @throws Error with the position of what is wrong.
  Match(const Element& element, const std::string& type);
  Match(Match&&) noexcept;
  ~Match();

  /// @param message Of the type given to the constructor.
  bool matches(const Message& message) const;

 private:
  void findField(const Element& element, std::string_view path);

  MessagePointer wanted_;
  /// From the message to the field to compare; empty if the whole message is compared.
  std::vector<const google::protobuf::FieldDescriptor*> path_;
  double tolerance_ = 1e-8;
  bool negative_ = false;
};

}  // namespace pongsim
