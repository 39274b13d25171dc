// How do words and pictures get into an XML file?
#pragma once

#include <string>
#include <string_view>

namespace halfdisk {

/// `<`, `&`, `"` and the like as XML wants them; what XML cannot hold (control characters, broken UTF-8)
/// becomes U+FFFD.
std::string xmlText(std::string_view text);

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

}  // namespace halfdisk
