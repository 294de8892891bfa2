#pragma once

#include <string>
#include <string_view>

namespace pongsim {

/// Appends `text` as the text of an element or as the value of an attribute in double quotes.
inline void appendXmlText(std::string_view text, std::string& xml) {
  for (const char letter : text) {
    switch (letter) {
      case '&':
        xml += "&amp;";
        break;
      case '<':
        xml += "&lt;";
        break;
      case '>':
        xml += "&gt;";
        break;
      case '"':
        xml += "&quot;";
        break;
      default:
        xml += letter;
    }
  }
}

/// @return `text` as `appendXmlText` writes it.
inline std::string xmlText(std::string_view text) {
  std::string xml;
  appendXmlText(text, xml);
  return xml;
}

}  // namespace pongsim
