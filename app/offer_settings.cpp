// Which settings, views and estimators can be chosen now?
#include <fmt/format.h>

#include <algorithm>

#include "app/key_help.h"
#include "app/language.h"
#include "app/offer.h"
#include "app/picture_stages.h"

namespace halfdisk {
namespace {

template <class Enum, std::size_t Count>
void choices(Offer& offer, std::string_view what, Enum Settings::*value,
             const std::array<Named<Enum>, Count>& table, std::string_view key) {
    Enum next = table[0].value;
    for (std::size_t i = 0; i < Count; ++i)
        if (table[i].value == offer.state.settings.*value) next = table[(i + 1) % Count].value;
    for (const Named<Enum>& choice : table) {
        Settings settings = offer.state.settings;
        if (settings.*value == choice.value) continue;
        settings.*value = choice.value;
        offer.add(fmt::format("{}: {}", tr(what), choice.name), choice.value == next ? key : "",
                  SetSettings{settings});
    }
}

/// Whether keys or switches change this view now.
bool isOffered(const AppState& state, View view) {
    if (state.rules.hidden.has(view)) return false;
    if (view == View::grid || view == View::eye || view == View::field) return true;  // keys do
    const Step* step = state.currentStep();
    const auto ofStepIn = [&](ViewSet set) {
        return step && (step->show & set) != ViewSet{} && set.has(view);
    };
    const bool ofStep = ofStepIn(kPictureSet) || ofStepIn(kInstrumentSet);
    return !state.rules.kiosk && (!step || state.unlockAll || ofStep);
}

/// Parameters with named choices; the others are numbers, which are typed.
void paramChoices(Offer& offer, const Makers& now) {
    const EstimatorInfo& info = *findEstimator(now.first->estimator);
    for (std::size_t i = 0; i < info.params.size(); ++i)
        for (std::size_t k = 0; k < info.params[i].choices.size(); ++k) {
            Makers makers = now;
            makers.first->params[i] = static_cast<double>(k);
            offer.addIf(now.first->params[i] != static_cast<double>(k),
                        fmt::format("{}: {} {}", info.id, info.params[i].name, info.params[i].choices[k]), {},
                        SetMakers{makers});
        }
}

}  // namespace

void offerSettings(Offer& offer) {
    const AppState& state = offer.state;
    const Settings& now = state.settings;
    const auto change = [&](bool there, std::string name, std::string_view key, const auto& how) {
        Settings settings = now;
        how(settings);
        offer.addIf(there, std::move(name), key, SetSettings{settings});
    };
    if (state.isUnlocked(Control::samples)) {
        change(now.samples < kMostLessonSamples, "Double N", keyOf(KeyRow::samples),
               [](Settings& s) { s.samples = std::min<std::uint32_t>(2 * s.samples, kMostLessonSamples); });
        change(now.samples > 1, "Halve N", keyOf(KeyRow::samples, 1),
               [](Settings& s) { s.samples = std::max(s.samples / 2, 1u); });
    }
    if (state.isUnlocked(Control::depth)) {
        change(now.maxDepth < kMostLessonDepth, "One scattering more", keyOf(KeyRow::depth),
               [](Settings& s) { ++s.maxDepth; });
        change(now.maxDepth > 0, "One scattering fewer", keyOf(KeyRow::depth, 1),
               [](Settings& s) { --s.maxDepth; });
    }
    if (state.isUnlocked(Control::seed))
        change(true, "Next seed", keyOf(KeyRow::seed), [](Settings& s) { ++s.seed; });
    if (state.isUnlocked(Control::sampler))
        choices(offer, "Sampler", &Settings::sampler, kSamplers, keyOf(KeyRow::samplerEmitters));
    if (state.isUnlocked(Control::emitters))
        choices(offer, "Emitters", &Settings::emitters, kEmitters, keyOf(KeyRow::samplerEmitters, 1));
    if (!state.isUnlocked(Control::defects)) return;
    constexpr std::string_view kDigits = "1234567";
    static_assert(kDigits.size() == kDefects.size());
    for (std::size_t i = 0; i < kDefects.size(); ++i) {
        const Defect defect = kDefects[i].value;
        const bool on = now.defects.has(defect);
        change(true, say("Defect {}: {}", kDefects[i].name, on ? "off" : "on"), kDigits.substr(i, 1),
               [&](Settings& s) { s.defects.set(defect, !on); });
    }
    const bool printed = now.defects == DefectSet::all();
    change(!printed, "All defects: as printed", keyOf(KeyRow::defects, 1),
           [](Settings& s) { s.defects = DefectSet::all(); });
    change(now.defects != DefectSet{}, "No defects", printed ? keyOf(KeyRow::defects, 1) : "",
           [](Settings& s) { s.defects = {}; });
}

void offerViews(Offer& offer) {
    for (const Named<View>& view : kViews) {
        if (!isOffered(offer.state, view.value)) continue;
        const std::string_view key = view.value == View::grid    ? keyOf(KeyRow::grid)
                                     : view.value == View::eye   ? keyOf(KeyRow::pictures)
                                     : view.value == View::field ? keyOf(KeyRow::pictures, 1)
                                                                 : std::string_view();
        const bool on = offer.state.shows(view.value);
        offer.add(fmt::format("{} {}: {}", tr(on ? "Hide" : "Show"), view.name, tr(view.meaning)), key,
                  SetView{view.value, !on});
    }
    const bool alone = offer.state.strategiesAlone;
    offer.addIf(offer.state.shows(View::strategies),
                alone ? "Strategies: with their weights" : "Strategies: each by itself", {},
                WeighStrategies{!alone});
}

void offerEstimators(Offer& offer) {
    const AppState& state = offer.state;
    const std::optional<View> view = state.mainPicture();
    if (!view) return;
    const Makers now{state.makers.first ? *state.makers.first : usualMaker(*view), state.makers.second};
    if (state.isUnlocked(Control::params)) paramChoices(offer, now);
    if (!state.isUnlocked(Control::estimator)) return;
    for (const EstimatorInfo* info : estimators())
        offer.addIf(now.first->estimator != info->id, say("Estimator: {}", info->id), {},
                    SetMakers{{makerOf(info->id), now.second}});
    offer.add(now.second ? "Compare: one estimator again" : "Compare with a second estimator", {},
              SetMakers{{now.first, now.second ? std::nullopt : std::optional(usualMaker(*view))}});
    if (!now.second) return;
    for (const EstimatorInfo* info : estimators())
        offer.addIf(now.second->estimator != info->id, say("Second estimator: {}", info->id), {},
                    SetMakers{{now.first, makerOf(info->id)}});
}

void offerPixels(Offer& offer) {
    const AppState& state = offer.state;
    offer.addIf(state.shows(View::samples),
                state.largestFirst ? "List of samples: as they came" : "List of samples: largest first", {},
                SortSamples{!state.largestFirst});
    if (!canPin(state, 0)) return;
    const auto pinned = state.pinnedPixel;
    const Side side = state.pinnedSide;
    const bool hasEscape = !state.editing.on && state.banner.empty() && state.notice.empty() &&
                           !state.exportWished && !state.helpShown;
    offer.addIf(pinned.has_value(), "Back to P from the pixel", hasEscape ? "Escape" : "", PinPixel{});
    offer.addIf(pinned && *pinned > 0, "One pixel to the left", keyOf(KeyRow::pixel),
                PinPixel{pinned.value_or(1) - 1, side});
    offer.addIf(pinned && *pinned + 1 < kEyeStripPixels, "One pixel to the right", keyOf(KeyRow::pixel, 1),
                PinPixel{pinned.value_or(0) + 1, side});
    const bool isSecond = side == Side::second;
    offer.addIf(pinned && state.makers.second,
                isSecond ? "The same pixel of strip A" : "The same pixel of strip B", {},
                PinPixel{pinned, isSecond ? Side::first : Side::second});
    for (std::uint32_t pixel = 0; pixel < kEyeStripPixels; ++pixel)
        offer.addIf(pixel != pinned, say("Look into pixel {} of the eye's strip", pixel), {},
                    PinPixel{pixel, side});
}

}  // namespace halfdisk
