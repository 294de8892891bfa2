#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace pongsim::sdf {

/// Why a text is not well-formed XML.
struct XmlFault {
  /// Offset of the fault in the text.
  std::size_t offset = 0;
  std::string message;
  std::string hint;
};

/// Finds the first fault in a text that the XML parser has rejected, to report it better than the parser does.
/// @return Nothing if no known kind of fault is found.
std::optional<XmlFault> findXmlFault(std::string_view text);

}  // namespace pongsim::sdf
