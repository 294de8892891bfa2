#include "msgs/types/definition.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/message.h>

#include <fstream>
#include <sstream>
#include <vector>

#include "pongsim/message.hh"

namespace pongsim::msgs {

namespace {

namespace pb = google::protobuf;

/// @return The comment without Doxygen's marks, as in "/ \brief Where it is".
std::string plain(const std::string& comment) {
  std::string text;
  std::istringstream lines(comment);
  for (std::string line; std::getline(lines, line);) {
    line.erase(0, line.find_first_not_of("/ "));
    constexpr std::string_view kBrief = "\\brief ";
    if (line.starts_with(kBrief)) line.erase(0, kBrief.size());
    if (!line.empty()) text += line + "\n";
  }
  return text;
}

/// @return The comment about a type at the head of its file: "\interface Twist", then "\brief" and so on. The name is
/// not always right, but in a file with one type it can't mean another.
std::string headComment(const pb::FileDescriptorProto& file, const std::string& type) {
  std::vector<std::string> all;
  for (const pb::SourceCodeInfo::Location& location : file.source_code_info().location()) {
    all.insert(all.end(), location.leading_detached_comments().begin(), location.leading_detached_comments().end());
    all.push_back(location.leading_comments());
  }
  for (const std::string& comment : all) {
    const std::string mark = "\\interface " + (file.message_type_size() == 1 ? std::string() : type + "\n");
    const std::size_t place = comment.find(mark);
    if (place != std::string::npos) return plain(comment.substr(comment.find('\n', place)));
  }
  return {};
}

/// Removes JSON names, which protoc writes for all fields although the files set none.
void removeJsonNames(pb::DescriptorProto& type) {
  for (pb::FieldDescriptorProto& field : *type.mutable_field()) field.clear_json_name();
  for (pb::DescriptorProto& nested : *type.mutable_nested_type()) removeJsonNames(nested);
}

/// Cleans up the comments, and gives each type of the file the comment at the head.
void cleanComments(pb::FileDescriptorProto& file) {
  std::vector<std::string> heads;
  for (const pb::DescriptorProto& type : file.message_type()) heads.push_back(headComment(file, type.name()));
  for (pb::SourceCodeInfo::Location& location : *file.mutable_source_code_info()->mutable_location()) {
    location.clear_leading_detached_comments();
    if (location.has_leading_comments()) location.set_leading_comments(plain(location.leading_comments()));
    if (location.has_trailing_comments()) location.set_trailing_comments(plain(location.trailing_comments()));
    const bool isType =
        location.path_size() == 2 && location.path(0) == pb::FileDescriptorProto::kMessageTypeFieldNumber;
    if (!isType) continue;
    const std::string& head = heads[static_cast<std::size_t>(location.path(1))];
    if (!head.empty()) location.set_leading_comments(head);
  }
}

std::optional<std::string> commentedDefinition(const std::string& type, const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  pb::FileDescriptorSet set;
  if (!stream.is_open() || !set.ParseFromIstream(&stream)) return std::nullopt;
  // each after those that it depends on, which is protoc's order
  pb::DescriptorPool pool;
  for (pb::FileDescriptorProto& each : *set.mutable_file()) {
    cleanComments(each);
    for (pb::DescriptorProto& own : *each.mutable_message_type()) removeJsonNames(own);
    if (pool.BuildFile(each) == nullptr) return std::nullopt;
  }
  const pb::Descriptor* const found = pool.FindMessageTypeByName(type);
  if (found == nullptr) return std::nullopt;
  pb::DebugStringOptions options;
  options.include_comments = true;
  return found->DebugStringWithOptions(options);
}

}  // namespace

std::optional<std::string> definition(std::string_view name, const std::filesystem::path& comments) {
  const MessagePointer message = newMessage(name);
  if (!message) return std::nullopt;
  const pb::Descriptor& type = *message->GetDescriptor();
  if (auto commented = commentedDefinition(type.full_name(), comments)) return commented;
  return type.DebugString();
}

std::optional<std::string> definitionFile(std::string_view name) {
  const MessagePointer message = newMessage(name);
  if (!message) return std::nullopt;
  return message->GetDescriptor()->file()->name();
}

}  // namespace pongsim::msgs
