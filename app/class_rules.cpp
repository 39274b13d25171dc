#include "app/class_rules.h"

#include <algorithm>

#include "app/cli_arguments.h"
#include "app/estimator_arguments.h"

namespace halfdisk {
namespace {

constexpr std::string_view kLock = "--lock", kHide = "--hide";

template <class Enum, std::size_t Count>
Enum named(std::string_view option, std::string_view text, const std::array<Named<Enum>, Count>& table) {
    if (const auto value = valueOf(table, text)) return *value;
    failArgument(option, text, fmt::format("is unknown, {}", expectedOneOf(text, namesOf(table))));
}

/// NAME:T; whether there is such a wall depends on the scene.
void checkPlace(const std::string& text, const std::string& value) {
    const std::size_t colon = value.rfind(':');
    const auto t = colon == std::string::npos ? std::nullopt : parseNumber(value.substr(colon + 1));
    if (colon == 0 || !t || !(*t >= 0.0 && *t <= 1.0))
        failArgument(kLock, text, "is no place, expected point=WALL:T with T from 0 to 1");
}

void setValue(ClassRules& rules, Control control, const std::string& text, const std::string& value) {
    const auto whole = [&](NumberInfo info, std::uint64_t most) {
        info.most = std::min(info.most, most);
        return wholeArgument(kLock, value, info);
    };
    switch (control) {
        case Control::samples:
            rules.samples = static_cast<std::uint32_t>(whole(kSamplesInfo, kMostLessonSamples));
            return;
        case Control::depth:
            rules.maxDepth = static_cast<std::uint32_t>(whole(kMaxDepthInfo, kMostLessonDepth));
            return;
        case Control::seed:
            rules.seed = whole(kSeedInfo, kSeedInfo.most);
            return;
        case Control::sampler:
            rules.sampler = named(kLock, value, kSamplers);
            return;
        case Control::emitters:
            rules.emitters = named(kLock, value, kEmitters);
            return;
        case Control::defects:
            rules.defects = defectsArgument(kLock, value);
            return;
        case Control::point:
            checkPlace(text, value);
            rules.point = value;
            return;
        case Control::estimator:
            rules.estimator = estimatorArgument(value).id;
            return;
        case Control::step:
        case Control::params:
            failArgument(kLock, text, "takes no value, expected the control alone");
    }
}

}  // namespace

void addLock(ClassRules& rules, const std::string& text) {
    const std::size_t equals = text.find('=');
    const Control control = named(kLock, text.substr(0, equals), kControls);
    if (equals != std::string::npos) setValue(rules, control, text, text.substr(equals + 1));
    rules.lock(control);
}

void addHidden(ClassRules& rules, const std::string& text) {
    if (const auto panel = valueOf(kPanels, std::string_view(text))) {
        (*panel == Panel::lesson ? rules.withoutLesson : rules.withoutControls) = true;
        return;
    }
    if (const auto view = valueOf(kViews, std::string_view(text))) return rules.hidden.set(*view, true);
    std::vector<std::string_view> names = namesOf(kPanels);
    for (const std::string_view view : namesOf(kViews)) names.push_back(view);
    failArgument(kHide, text, fmt::format("is unknown, {}", expectedOneOf(text, names)));
}

void obey(const ClassRules& rules, const Scene& scene, StepValues& values) {
    Settings& settings = values.settings;
    settings.samples = rules.samples.value_or(settings.samples);
    settings.maxDepth = rules.maxDepth.value_or(settings.maxDepth);
    settings.seed = rules.seed.value_or(settings.seed);
    settings.sampler = rules.sampler.value_or(settings.sampler);
    settings.emitters = rules.emitters.value_or(settings.emitters);
    settings.defects = rules.defects.value_or(settings.defects);
    const bool another =
        rules.estimator && (!values.makers.first || values.makers.first->estimator != *rules.estimator);
    if (another) values.makers.first = makerOf(*rules.estimator);
    if (!rules.point) return;
    try {
        values.at = parseWallPoint(*rules.point, scene);
    } catch (const InputError&) {
        // Another scene has other walls: there P stands where the step puts it.
    }
}

}  // namespace halfdisk
