#include "sdf/text/xml_fault.hh"

#include <algorithm>
#include <vector>

#include "sdf/text/text_cursor.hh"

namespace pongsim::sdf {

namespace {

// One less than tinyxml2's limit, which counts the document too.
constexpr std::size_t kDeepest = 98;
constexpr std::size_t kLongestName = 40;

bool isNameStart(char letter) {
  const auto byte = static_cast<unsigned char>(letter);
  return byte >= 0x80 || (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || byte == ':' || byte == '_';
}

bool isNamePart(char letter) {
  return isNameStart(letter) || (letter >= '0' && letter <= '9') || letter == '.' || letter == '-';
}

class FaultFinder {
 public:
  explicit FaultFinder(std::string_view text) : text_(text), at_(TextCursor::startOf(text)) {}

  std::optional<XmlFault> find() {
    skipWhiteSpace();
    if (at_ < text_.size() && text_[at_] != '<')
      fail(at_, "the file does not begin with a tag", "is this an SDF file?");
    while (!fault_ && (at_ = text_.find('<', at_)) != std::string_view::npos) readMarkup();
    if (!fault_ && !open_.empty()) {
      fail(open_.back().offset, "<" + std::string(open_.back().name) + "> is not closed",
           "the file ends before its </" + std::string(open_.back().name) + ">");
    }
    return std::move(fault_);
  }

 private:
  struct OpenTag {
    std::string_view name;
    std::size_t offset;
  };

  void fail(std::size_t offset, std::string message, std::string hint = {}) {
    fault_ = XmlFault{offset, std::move(message), std::move(hint)};
  }

  void readMarkup() {
    const std::string_view rest = text_.substr(at_);
    if (rest.starts_with("<!--")) return skipUntil("-->", "<!-- is not closed with -->");
    if (rest.starts_with("<![CDATA[")) return skipUntil("]]>", "<![CDATA[ is not closed with ]]>");
    if (rest.starts_with("<?")) {
      if (sawElement_) return fail(at_, "<?...?> must be at the beginning of the file", "move it to the first line");
      return skipUntil("?>", "<? is not closed with ?>");
    }
    if (rest.starts_with("<!")) return skipUntil(">", "<! is not closed with >");
    if (rest.starts_with("</")) return readClosingTag();
    readOpeningTag();
  }

  void skipUntil(std::string_view end, std::string messageIfMissing) {
    // The opening mark must not also count as the closing one, as in "<!-->".
    const std::size_t body = at_ + (end == "-->" ? 4 : 2);
    const std::size_t found = text_.find(end, body);
    if (found == std::string_view::npos) return fail(at_, std::move(messageIfMissing));
    at_ = found + end.size();
  }

  void skipWhiteSpace() { at_ = std::min(text_.find_first_not_of(kWhiteSpace, at_), text_.size()); }

  std::string_view readName() {
    const std::size_t begin = at_;
    if (at_ < text_.size() && isNameStart(text_[at_])) {
      while (at_ < text_.size() && isNamePart(text_[at_])) ++at_;
    }
    return text_.substr(begin, at_ - begin);
  }

  void readClosingTag() {
    const std::size_t begin = at_;
    at_ += 2;
    const std::string name(readName());
    skipWhiteSpace();
    if (name.empty() || at_ >= text_.size() || text_[at_] != '>') {
      return fail(begin, "</" + name + " is not closed with >");
    }
    ++at_;
    if (open_.empty()) return fail(begin, "</" + name + "> closes nothing", "no <" + name + "> is open here");
    if (open_.back().name != name) return failMismatch(begin, name);
    open_.pop_back();
  }

  void failMismatch(std::size_t offset, const std::string& name) {
    const OpenTag& last = open_.back();
    TextCursor cursor(text_);
    cursor.advanceTo(last.offset);
    const std::string lastName(last.name);
    fail(offset, "</" + name + "> stands where </" + lastName + "> should be",
         "<" + lastName + "> was opened in line " + std::to_string(cursor.line()) + ", column " +
             std::to_string(cursor.column()) + ", and is not closed");
  }

  void readOpeningTag() {
    const std::size_t begin = at_++;
    sawElement_ = true;
    const std::string_view name = readName();
    if (name.empty()) return fail(begin, "'<' does not begin a tag", "in text, write &lt; for '<'");
    std::vector<std::string_view> attributes;
    while (!fault_) {
      skipWhiteSpace();
      if (at_ >= text_.size()) return fail(begin, "the tag <" + std::string(name) + " is not closed with >");
      if (text_[at_] == '>') {
        ++at_;
        open_.push_back({name, begin});
        if (open_.size() > kDeepest) fail(begin, "elements nest more than " + std::to_string(kDeepest) + " deep");
        return;
      }
      if (text_.substr(at_).starts_with("/>")) {
        at_ += 2;
        return;
      }
      readAttribute(name, attributes);
    }
  }

  void readAttribute(std::string_view tag, std::vector<std::string_view>& attributes) {
    const std::size_t begin = at_;
    const std::string inTag = " in <" + std::string(tag) + ">";
    const std::string_view name = readName();
    if (name.empty())
      return fail(begin, "'" + std::string(1, text_[at_]) + "' where an attribute was expected" + inTag);
    const std::string label = "attribute '" + std::string(name.substr(0, kLongestName)) + "'";
    skipWhiteSpace();
    if (at_ >= text_.size() || text_[at_] != '=') return fail(begin, label + inTag + " has no value");
    ++at_;
    skipWhiteSpace();
    if (at_ >= text_.size() || (text_[at_] != '"' && text_[at_] != '\'')) {
      return fail(begin, "the value of " + label + inTag + " has no quotes around it");
    }
    const std::size_t end = text_.find(text_[at_], at_ + 1);
    if (end == std::string_view::npos) return fail(begin, "the value of " + label + inTag + " has no closing quote");
    at_ = end + 1;
    if (std::find(attributes.begin(), attributes.end(), name) != attributes.end()) {
      return fail(begin, label + inTag + " is given twice");
    }
    attributes.push_back(name);
  }

  std::string_view text_;
  std::size_t at_;
  bool sawElement_ = false;
  std::vector<OpenTag> open_;
  std::optional<XmlFault> fault_;
};

}  // namespace

std::optional<XmlFault> findXmlFault(std::string_view text) { return FaultFinder(text).find(); }

}  // namespace pongsim::sdf
