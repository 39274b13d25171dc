#include "app/shown_pictures.h"

#include "app/language.h"
#include "app/picture_stages.h"

namespace halfdisk {

std::string makerTitle(const Maker& maker, const Maker* other) {
    const std::string_view title = tr(findEstimator(maker.estimator)->title);
    const std::string difference = other ? differenceOf(maker, *other) : "";
    return difference.empty() ? std::string(title) : fmt::format("{}, {}", title, difference);
}

std::vector<ShownPicture> shownPictures(const AppState& state, View view) {
    std::vector<ShownPicture> shown;
    if (!state.answer) return shown;
    const LightAnswer& answer = *state.answer;
    const Maker first = answer.asked.makers.first.value_or(usualMaker(view));
    const Maker* second = answer.asked.makers.second ? &*answer.asked.makers.second : nullptr;
    const auto add = [&](const std::shared_ptr<const LightPicture>& picture, const Maker& maker,
                         const Maker* other, bool isSecond) {
        if (picture && picture->film.passes > 0)
            shown.push_back({picture.get(), makerTitle(maker, other), isSecond});
    };
    add(answer.pictures.of(view), first, second, false);
    if (second) add(answer.against.of(view), *second, &first, true);
    return shown;
}

}  // namespace halfdisk
