#include "sdf/text/document.hh"

#include <tinyxml2.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "sdf/text/text_cursor.hh"
#include "sdf/text/xml_fault.hh"

namespace pongsim::sdf {

namespace {

/// Copies tinyxml2's tree and computes columns, which tinyxml2 does not know. tinyxml2's names of elements and
/// attributes point into its copy of the text, so their offsets from the first node are known.
class TreeCopier {
 public:
  TreeCopier(const tinyxml2::XMLDocument& document, std::string_view text, std::shared_ptr<const std::string> file,
             Diagnostics& diagnostics)
      : text_(text), cursor_(text), file_(std::move(file)), diagnostics_(diagnostics) {
    const tinyxml2::XMLNode* first = document.FirstChild();
    std::size_t markLength = 1;  // "<"
    if (first->ToComment() != nullptr) markLength = 4;
    if (first->ToDeclaration() != nullptr || first->ToUnknown() != nullptr) markLength = 2;
    anchor_ = first->Value();
    anchorOffset_ = text.find_first_not_of(kWhiteSpace, TextCursor::startOf(text)) + markLength;
  }

  void copy(const tinyxml2::XMLElement& from, Element& to) {
    to.name = from.Name();
    to.position = position(from.Name(), to.name, from.GetLineNum(), 1);
    for (const tinyxml2::XMLAttribute* attribute = from.FirstAttribute(); attribute != nullptr;
         attribute = attribute->Next()) {
      Element::Attribute& added = to.attributes.emplace_back();
      added.name = attribute->Name();
      added.value = attribute->Value();
      added.position = position(attribute->Name(), added.name, attribute->GetLineNum(), 0);
      check(added.value, added.position);
    }
    std::size_t childCount = 0;
    for (const auto* child = from.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
      ++childCount;
    }
    to.children.reserve(childCount);
    for (const tinyxml2::XMLNode* child = from.FirstChild(); child != nullptr; child = child->NextSibling()) {
      if (const tinyxml2::XMLElement* element = child->ToElement()) copy(*element, to.children.emplace_back());
      if (const tinyxml2::XMLText* text = child->ToText()) to.text += text->Value();
    }
    to.text = std::string(base::trimmed(to.text));
    check(to.text, to.position);
  }

 private:
  /// Refuses control characters, which XML does not allow, also written as `&#27;`: in a name they would reach
  /// terminals.
  void check(std::string_view value, const SourcePosition& position) {
    const auto isControl = [](unsigned char byte) {
      return byte == 0x7f || (byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r');
    };
    const auto found = std::ranges::find_if(value, isControl);
    if (found == value.end()) return;
    char code[8];
    std::snprintf(code, sizeof code, "U+%04X", static_cast<unsigned char>(*found));
    diagnostics_.error(position, std::string("it contains the control character ") + code, "XML does not allow it");
  }

  /// @param before Number of characters between the wanted position and the name.
  SourcePosition position(const char* name, std::string_view expected, int line, std::size_t before) {
    const std::ptrdiff_t signedOffset = static_cast<std::ptrdiff_t>(anchorOffset_) + (name - anchor_);
    const auto offset = static_cast<std::size_t>(signedOffset);
    const bool found = signedOffset >= static_cast<std::ptrdiff_t>(cursor_.offset() + before) &&
                       offset < text_.size() && text_.substr(offset).starts_with(expected);
    if (!found) return {file_, line, 0};
    cursor_.advanceTo(offset - before);
    return {file_, cursor_.line(), cursor_.column()};
  }

  std::string_view text_;
  TextCursor cursor_;
  std::shared_ptr<const std::string> file_;
  Diagnostics& diagnostics_;
  const char* anchor_ = nullptr;
  std::size_t anchorOffset_ = 0;
};

void explainFault(const tinyxml2::XMLDocument& document, std::string_view text,
                  const std::shared_ptr<const std::string>& file, Diagnostics& diagnostics) {
  if (document.ErrorID() == tinyxml2::XML_ERROR_EMPTY_DOCUMENT) {
    return diagnostics.error({file}, "this file contains no XML");
  }
  const std::optional<XmlFault> fault = findXmlFault(text);
  if (!fault) {
    const std::string where = document.ErrorLineNum() > 0 ? " here" : "";
    return diagnostics.error({file, document.ErrorLineNum(), 0}, "the XML is not well-formed" + where);
  }
  TextCursor cursor(text);
  cursor.advanceTo(fault->offset);
  diagnostics.error({file, cursor.line(), cursor.column()}, fault->message, fault->hint);
}

/// Warns about entities defined in the file: tinyxml2 knows only the predefined ones, and treats others as text.
void warnOfEntities(const tinyxml2::XMLDocument& document, std::string_view text,
                    const std::shared_ptr<const std::string>& file, Diagnostics& diagnostics) {
  constexpr std::string_view kMark = "<!ENTITY";
  for (const tinyxml2::XMLNode* node = document.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node->ToUnknown() == nullptr || std::string_view(node->Value()).find(kMark) == std::string_view::npos) continue;
    TextCursor cursor(text);
    cursor.advanceTo(text.find(kMark));
    return diagnostics.warning({file, cursor.line(), cursor.column()},
                               "entities are not expanded: '&NAME;' stays as it is",
                               "as in Fortress; write its text instead");
  }
}

/// tinyxml2 compares each attribute with all before it.
constexpr std::size_t kMostAttributes = 1000;

/// @return Where an element with more than `kMostAttributes` begins; npos if there is none.
std::size_t findTooManyAttributes(std::string_view text) {
  for (std::size_t begin = text.find('<'); begin != std::string_view::npos;) {
    std::size_t at = begin + 1;
    for (const auto& [mark, end] : {std::pair("<!--", "-->"), std::pair("<![CDATA[", "]]>")}) {
      if (text.substr(begin).starts_with(mark)) at = text.find(end, begin);
    }
    std::size_t count = 0;
    while (at < text.size() && text[at] != '>') {
      if (text[at] == '"' || text[at] == '\'') {
        if (++count > kMostAttributes) return begin;
        at = text.find(text[at], at + 1);
        if (at == std::string_view::npos) break;
      }
      ++at;
    }
    begin = at < text.size() ? text.find('<', at) : std::string_view::npos;
  }
  return std::string_view::npos;
}

}  // namespace

std::optional<Element> parseDocument(std::string_view text, std::shared_ptr<const std::string> file,
                                     Diagnostics& diagnostics) {
  // tinyxml2 would stop at a zero byte and ignore the rest.
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    TextCursor cursor(text);
    cursor.advanceTo(zero);
    diagnostics.error({std::move(file), cursor.line(), cursor.column()}, "the text contains a zero byte",
                      "is this a text file, in UTF-8?");
    return std::nullopt;
  }
  if (const std::size_t wide = findTooManyAttributes(text); wide != std::string_view::npos) {
    TextCursor cursor(text);
    cursor.advanceTo(wide);
    diagnostics.error(
        {std::move(file), cursor.line(), cursor.column()},
        "an element has more than " + std::to_string(kMostAttributes) + " attributes, which is the limit");
    return std::nullopt;
  }
  tinyxml2::XMLDocument document;
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    explainFault(document, text, file, diagnostics);
    return std::nullopt;
  }
  warnOfEntities(document, text, file, diagnostics);
  const tinyxml2::XMLElement* root = document.FirstChildElement("sdf");
  if (root == nullptr) root = document.FirstChildElement();
  if (root == nullptr) {
    diagnostics.error({std::move(file)}, "this file contains no element");
    return std::nullopt;
  }
  std::optional<Element> copied(std::in_place);
  TreeCopier(document, text, std::move(file), diagnostics).copy(*root, *copied);
  return copied;
}

}  // namespace pongsim::sdf
