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

/// Adds the path of the file that a text names, if any.
void addNamed(std::string_view text, std::vector<std::string>& paths) {
  const std::string_view path = withoutFileScheme(text);
  if (path.starts_with('/') && isOfModels(path)) paths.emplace_back(path);
}

/// Adds the paths of all files that a message names.
void addNamedIn(const Message& message, std::vector<std::string>& paths) {
  const google::protobuf::Reflection& reflection = *message.GetReflection();
  std::vector<const google::protobuf::FieldDescriptor*> fields;
  reflection.ListFields(message, &fields);
  for (const google::protobuf::FieldDescriptor* const field : fields) {
    const bool isMessage = field->cpp_type() == google::protobuf::FieldDescriptor::CPPTYPE_MESSAGE;
    if (isMessage && field->is_repeated()) {
      for (int i = 0; i < reflection.FieldSize(message, field); ++i)
        addNamedIn(reflection.GetRepeatedMessage(message, field, i), paths);
    } else if (isMessage) {
      addNamedIn(reflection.GetMessage(message, field), paths);
    } else if (field->type() == google::protobuf::FieldDescriptor::TYPE_STRING && !field->is_repeated()) {
      addNamed(reflection.GetString(message, field), paths);
    }
  }
}

/// @return The closest folder around a file that has a `model.config`; nothing if there is none.
std::optional<std::filesystem::path> modelFolder(const std::filesystem::path& file) {
  std::error_code error;
  for (std::filesystem::path folder = file.parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
    if (std::filesystem::exists(folder / "model.config", error)) return folder;
  }
  return {};
}

bool isWithinOne(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& file) {
  return std::ranges::any_of(folders, [&](const auto& folder) { return isWithin(folder, file); });
}

/// @return Whether the path leads upwards somewhere, so that its names do not tell where it ends.
bool leadsUp(const std::filesystem::path& path) { return std::ranges::find(path, "..") != path.end(); }

}  // namespace

WorldFiles::WorldFiles(const Message& scene, const std::vector<std::string>& more) {
  std::vector<std::string> paths;
  addNamedIn(scene, paths);
  for (const std::string& file : more) addNamed(file, paths);
  for (const std::string& path : paths) add(path);
}

void WorldFiles::add(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::canonical(file, error);
  if (error || !files_.insert(real).second) return;
  if (const std::optional<std::filesystem::path> model = modelFolder(real)) {
    folders_.insert({*model, true});
    return;
  }
  const std::filesystem::path folder = real.parent_path();
  folders_.insert({folder, false});
  if (std::ranges::find(kParts, folder.filename().string()) == std::end(kParts)) return;
  for (const std::string_view part : kParts) folders_.insert({folder.parent_path() / part, true});
}

std::vector<std::string> WorldFiles::addInserted(const Message& scene,
                                                 const std::vector<std::filesystem::path>& folders) {
  std::vector<std::filesystem::path> real, asWritten;
  std::error_code error;
  for (const std::filesystem::path& folder : folders) {
    const std::filesystem::path place = std::filesystem::canonical(folder, error);
    if (error) continue;
    real.push_back(place);
    // without a slash at the end
    asWritten.push_back((std::filesystem::absolute(folder) / "").lexically_normal().parent_path());
  }
  std::vector<std::string> paths, refused;
  addNamedIn(scene, paths);
  for (const std::string& path : paths) {
    const std::filesystem::path file = std::filesystem::canonical(path, error);
    if (error || files_.contains(file)) continue;
    // a symbolic link in a folder of models was put there by its owner
    if (!isWithinOne(real, file) && (leadsUp(path) || !isWithinOne(asWritten, path))) {
      refused.push_back(path);
      continue;
    }
    files_.insert(file);
    const std::optional<std::filesystem::path> model = modelFolder(file);
    if (model && isWithinOne(real, *model)) folders_.insert({*model, true});
  }
  return refused;
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
