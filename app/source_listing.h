// What source does the code panel show? The compiled castRay itself, with the published listing's line
// numbers; of the other estimators the compiled parts that a recorded run passes.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/path_recorder.h"
#include "lessons/lesson.h"

namespace halfdisk {

struct ListingLine {
    int number = 0;  ///< of the published listing; 0: a line that it does not have
    std::string text;
    bool comment = false;
    std::string_view
        file{};      ///< of an estimator's own listing; a line without a source number is its heading
    int source = 0;  ///< the line in that file; 0: not of a file
};

using Listing = std::vector<ListingLine>;

/// The part between "// [listing]" and "// [end]". A trailing "// 017" becomes the line's number. What serves
/// the observer (calls of `see`, template heads and qualifiers) is left out; a statement is one line,
/// and indentation is halved.
Listing parseListing(std::string_view source);

/// All parts of an estimator's source between "// [listing]" and "// [end]", under a heading with the file's
/// name. What serves the observer, or calls it off, is left out as above.
Listing parseRunListing(std::string_view file, std::string_view source);

struct Listings {
    Listing corrected;
    Listing asPrinted;
    std::array<Listing, kRuns.size()> runs;  ///< by Run; that of castRay is empty
};
Listings loadListings();

/// Which line of an estimator's listing told a step: its index, or -1.
int lineOf(const Listing& listing, const SourceLine& where);

}  // namespace halfdisk
