// How is a message of the light, or of a file's reader, told in the window's language? These speak English
// and know of no other; what they say is recognised by the forms in a language's [messages].
#pragma once

#include <string>
#include <string_view>

namespace halfdisk {

/// A message in the context's language: a whole sentence of [words] or [messages], or a form of [messages]
/// with values for its {}, which are told likewise if they are more than one word. What stands before a ": ",
/// such as file:line:column, stays as it is. A message of no known form is returned unchanged.
std::string trMessage(std::string_view message);

}  // namespace halfdisk
