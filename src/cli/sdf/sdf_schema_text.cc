#include "cli/sdf/sdf_schema_text.hh"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "sdf/schema/schema.hh"

namespace pongsim::cli {

namespace {

using sdf::Schema;

constexpr int kOldest = 4, kNewest = 9;

/// Escapes `text` for an attribute in single quotes.
std::string inSingleQuotes(std::string_view text) {
  std::string result = "'";
  for (const char letter : text) {
    if (letter == '\'') {
      result += "&apos;";
    } else if (letter == '&') {
      result += "&amp;";
    } else if (letter == '<') {
      result += "&lt;";
    } else {
      result += letter;
    }
  }
  return result + "'";
}

class SchemaWriter {
 public:
  explicit SchemaWriter(int version) : version_(version) {}

  std::string write() && {
    addElement(Schema::instance().root(), "1");
    return std::move(text_);
  }

 private:
  bool isThere(const Schema::Part& part) const {
    return part.row.since <= version_ && (part.row.removedIn == 0 || version_ < part.row.removedIn);
  }

  void line(const std::string& text) { text_ += std::string(2 * depth_, ' ') + text + "\n"; }

  /// What follows the name of an element or attribute.
  static std::string value(const Schema::Part& part) {
    if (part.row.type.empty()) return "";
    return " type =" + inSingleQuotes(part.row.type) + " default =" + inSingleQuotes(part.row.fallback);
  }

  void addDescription(const Schema::Part& part) {
    if (!part.row.description.empty()) {
      line("<description><![CDATA[" + std::string(part.row.description) + "]]></description>");
    }
  }

  void addAttribute(const Schema::Part& part) {
    const std::string fallback(part.name == "version" && depth_ == 1 ? "1." + std::to_string(version_)
                                                                     : std::string(part.row.fallback));
    line("<attribute name =" + inSingleQuotes(part.name) + " type =" + inSingleQuotes(part.row.type) +
         " default =" + inSingleQuotes(fallback) + " required ='" + (part.row.presence == '1' ? "1" : "0") + "'>");
    ++depth_;
    addDescription(part);
    --depth_;
    line("</attribute>");
  }

  void addElement(const Schema::Part& part, const std::string& presence) {
    if (part.name == "*") return line("<element copy_data ='true' required ='*'/>");
    if (part.type != nullptr && std::ranges::count(open_, part.type) > 0) {
      return line("<element ref =" + inSingleQuotes(part.name) + " required =" + inSingleQuotes(presence) + "/>");
    }
    line("<element name =" + inSingleQuotes(part.name) + " required =" + inSingleQuotes(presence) + value(part) + ">");
    ++depth_;
    addDescription(part);
    if (part.type != nullptr) addParts(*part.type);
    --depth_;
    line("</element>");
  }

  void addParts(const Schema::ElementType& type) {
    open_.push_back(&type);
    for (const Schema::Part& attribute : type.attributes) {
      if (isThere(attribute)) addAttribute(attribute);
    }
    for (const Schema::Part& child : type.children) {
      if (isThere(child)) addElement(child, std::string(1, child.row.presence));
    }
    open_.pop_back();
  }

  int version_;
  std::size_t depth_ = 0;
  std::vector<const Schema::ElementType*> open_;
  std::string text_;
};

}  // namespace

std::optional<int> sdfVersion(std::string_view text) {
  if (text.size() != 3 || !text.starts_with("1.")) return std::nullopt;
  const int version = text[2] - '0';
  return version >= kOldest && version <= kNewest ? std::optional(version) : std::nullopt;
}

std::string schemaText(int version) { return SchemaWriter(version).write(); }

}  // namespace pongsim::cli
