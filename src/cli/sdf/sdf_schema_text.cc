#include "cli/sdf/sdf_schema_text.hh"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "sdf/schema/schema.hh"
#include "sdf/version.hh"

namespace pongsim::cli {

namespace {

using sdf::Schema;

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
  bool isThere(const Schema::Part& part) const { return part.row.isIn(version_); }

  void line(const std::string& text) { text_ += std::string(2 * depth_, ' ') + text + "\n"; }

  /// What follows the name of an element or attribute.
  std::string value(const Schema::Part& part) const {
    if (part.row.type.empty()) return "";
    return " type =" + inSingleQuotes(part.row.type) + " default =" + inSingleQuotes(part.row.fallback.in(version_));
  }

  void addDescription(const Schema::Part& part) {
    if (!part.row.description.empty()) {
      line("<description><![CDATA[" + std::string(part.row.description) + "]]></description>");
    }
  }

  void addAttribute(const Schema::Part& part) {
    const std::string fallback(part.name == "version" && depth_ == 1 ? "1." + std::to_string(version_)
                                                                     : std::string(part.row.fallback.in(version_)));
    line("<attribute name =" + inSingleQuotes(part.name) + " type =" + inSingleQuotes(part.row.type) + " default =" +
         inSingleQuotes(fallback) + " required ='" + (part.row.presence.in(version_) == '1' ? "1" : "0") + "'>");
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
      if (isThere(child)) addElement(child, std::string(1, child.row.presence.in(version_)));
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
  const std::optional<int> version = sdf::parseVersion(text);
  const bool isDescribed = version && *version >= sdf::kOldestVersion && *version <= sdf::kNewestVersion;
  return isDescribed ? version : std::nullopt;
}

std::string schemaText(int version) { return SchemaWriter(version).write(); }

}  // namespace pongsim::cli
