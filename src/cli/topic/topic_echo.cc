#include <exception>
#include <string>
#include <vector>

#include "cli/topic/topic_command.hh"
#include "pongsim/messages/field_path.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

/// @return The text as a CSV field (RFC 4180), quoted if necessary.
std::string csvText(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + "\"";
}

class EchoTask final : public TopicTask {
 public:
  explicit EchoTask(const EchoOptions& options) : options_(options) {}

  std::optional<int> begin(const std::string& type) override {
    const bool isTable = options_.format == EchoFormat::kCsv;
    const std::vector<std::string> paths = isTable && options_.fields.empty() ? scalarPaths(type) : options_.fields;
    for (const std::string& path : paths) {
      MessageError error;
      std::optional<FieldPath> field = FieldPath::parse(type, path, error);
      if (!field) return fail(error.message, error.hint);
      fields_.push_back(*std::move(field));
    }
    if (!isTable) return std::nullopt;
    std::string header;
    for (const std::string& path : paths) header += (header.empty() ? "" : ",") + csvText(path);
    return printed(header + "\n");
  }

  std::optional<int> take(const Message& message) override {
    try {
      return printed(textOf(message) + "\n");
    } catch (const std::exception& error) {
      return fail(error.what());
    }
  }

  int end(bool) override { return kDone; }

 private:
  static std::optional<int> printed(const std::string& text) {
    if (print(text)) return std::nullopt;
    return outputIsClosed() ? kDone : kFailed;
  }

  std::string textOf(const Message& message) const {
    if (options_.format == EchoFormat::kJson) return messageJson(message);
    if (options_.format == EchoFormat::kText && fields_.empty()) return messageText(message);
    std::string text;
    for (const FieldPath& field : fields_) {
      const std::string value = field.valueIn(message).value_or("");
      if (&field != &fields_.front()) text += options_.format == EchoFormat::kCsv ? "," : "\t";
      text += options_.format == EchoFormat::kCsv ? csvText(value) : value;
    }
    return text;
  }

  const EchoOptions& options_;
  std::vector<FieldPath> fields_;
};

}  // namespace

int echoTopic(const EchoOptions& options) {
  TopicReader reader(options.read);
  EchoTask task(options);
  return reader.run(task);
}

}  // namespace pongsim::cli
