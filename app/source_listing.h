// What source does the code panel show? The compiled castRay itself, with the published listing's line
// numbers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace halfdisk {

struct ListingLine {
    int number = 0;  ///< of the published listing; 0: a line that it does not have
    std::string text;
    bool comment = false;
};

using Listing = std::vector<ListingLine>;

/// The part between "// [listing]" and "// [end]". A trailing "// 017" becomes the line's number. What serves
/// the observer (calls of `see`, template heads and qualifiers) is left out; a statement is one line,
/// and indentation is halved.
Listing parseListing(std::string_view source);

struct Listings {
    Listing corrected;
    Listing asPrinted;
};
Listings loadListings();

}  // namespace halfdisk
