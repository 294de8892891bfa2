#include "web/assets/world_files.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <algorithm>
#include <string>
#include <system_error>

#include "web/server/media_type.hh"

namespace pongsim::web {

namespace {

constexpr std::string_view kFile = "file://";
constexpr std::string_view kModel = "model://";
// Folders to serve of a model without model.config.
constexpr std::string_view kParts[] = {"meshes", "materials"};

std::string_view withoutFileScheme(std::string_view address) {
  if (address.starts_with(kFile)) address.remove_prefix(kFile.size());
  return address;
}

/// @return Whether it is a type of file used by models. Types used by pages are excluded: a script from here would have
/// the server's own origin.
bool isOfModels(const std::filesystem::path& file) {
  const std::string_view type = mediaType(file);
  return type.starts_with("image/") || type.starts_with("model/") || type == "application/octet-stream";
}

bool isWithin(const std::filesystem::path& folder, const std::filesystem::path& file) {
  return std::ranges::mismatch(folder, file).in1 == folder.end();
}

}  // namespace

WorldFiles::WorldFiles(const Message& scene, const std::vector<std::string>& more) {
  addFilesOf(scene);
  for (const std::string& file : more) addNamed(file);
}

/// Adds the file that a text names, if any.
void WorldFiles::addNamed(std::string_view text) {
  const std::string_view path = withoutFileScheme(text);
  if (path.starts_with('/') && isOfModels(path)) add(path);
}

void WorldFiles::addFilesOf(const Message& message) {
  const google::protobuf::Reflection& reflection = *message.GetReflection();
  std::vector<const google::protobuf::FieldDescriptor*> fields;
  reflection.ListFields(message, &fields);
  for (const google::protobuf::FieldDescriptor* const field : fields) {
    const bool isMessage = field->cpp_type() == google::protobuf::FieldDescriptor::CPPTYPE_MESSAGE;
    if (isMessage && field->is_repeated()) {
      for (int i = 0; i < reflection.FieldSize(message, field); ++i)
        addFilesOf(reflection.GetRepeatedMessage(message, field, i));
    } else if (isMessage) {
      addFilesOf(reflection.GetMessage(message, field));
    } else if (field->type() == google::protobuf::FieldDescriptor::TYPE_STRING && !field->is_repeated()) {
      addNamed(reflection.GetString(message, field));
    }
  }
}

void WorldFiles::add(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::canonical(file, error);
  if (error || !files_.insert(real).second) return;
  for (std::filesystem::path folder = real.parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
    if (!std::filesystem::exists(folder / "model.config", error)) continue;
    folders_.insert({folder, true});
    return;
  }
  const std::filesystem::path folder = real.parent_path();
  folders_.insert({folder, false});
  if (std::ranges::find(kParts, folder.filename().string()) == std::end(kParts)) return;
  for (const std::string_view part : kParts) folders_.insert({folder.parent_path() / part, true});
}

bool WorldFiles::has(const std::filesystem::path& file) const {
  if (files_.contains(file)) return true;
  return std::ranges::any_of(folders_, [&](const Folder& folder) {
    return folder.isDeep ? isWithin(folder.path, file) : file.parent_path() == folder.path;
  });
}

std::optional<std::filesystem::path> WorldFiles::find(std::string_view address) const {
  if (address.find('\0') != std::string_view::npos) return {};
  std::vector<std::filesystem::path> places;
  if (address.starts_with(kModel)) {
    const std::filesystem::path rest(address.substr(kModel.size()));
    if (rest.empty() || rest.is_absolute()) return {};
    for (const Folder& folder : folders_) {
      if (folder.path.filename() == *rest.begin()) places.push_back(folder.path.parent_path() / rest);
    }
  } else {
    places.emplace_back(withoutFileScheme(address));
  }
  for (const std::filesystem::path& place : places) {
    std::error_code error;
    if (!place.is_absolute() || !isOfModels(place)) continue;
    const std::filesystem::path real = std::filesystem::canonical(place, error);
    if (error || !isOfModels(real) || !std::filesystem::is_regular_file(real, error)) continue;
    if (has(real)) return real;
  }
  return {};
}

}  // namespace pongsim::web
