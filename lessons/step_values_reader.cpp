#include "lessons/step_values_reader.h"

#include <algorithm>
#include <limits>

namespace halfdisk {
namespace {

constexpr TextRule kPlaceRule{200, false, false};

WallPoint readWallPoint(const std::string& file, const TomlValue& value, const Scene& scene) {
    const std::string text = readText(file, "at", value, kPlaceRule);
    try {
        return parseWallPoint(text, scene);
    } catch (const InputError& error) {
        failAt(file, value.where, fmt::format("\"at\": {}", error.text));
    }
}

DefectSet readDefects(const std::string& file, const TomlValue& value) {
    if (const auto* all = std::get_if<bool>(&value.data)) return *all ? DefectSet::all() : DefectSet{};
    DefectSet set;
    readSet(file, "asPrinted", value, "true, false or an array of names", kDefects, set);
    return set;
}

}  // namespace

void readSettings(TableReader& table, const Scene& scene, const StepLimits& limits, Settings& settings,
                  WallPoint& at) {
    const std::string& file = table.file();
    const auto whole = [&](const NumberInfo& info, std::uint64_t most, auto& field) {
        if (const TomlValue* number = table.optional(info.name))
            field = static_cast<std::remove_reference_t<decltype(field)>>(
                readWhole(file, info.name, *number, {info.least, std::min(info.most, most)}));
    };
    whole(kSamplesInfo, limits.samples, settings.samples);
    whole(kMaxDepthInfo, limits.depth, settings.maxDepth);
    whole(kSeedInfo, std::numeric_limits<std::int64_t>::max(), settings.seed);
    if (const TomlValue* sampler = table.optional("sampler"))
        settings.sampler = readNamed(file, "sampler", *sampler, kSamplers);
    if (const TomlValue* emitters = table.optional("emitters"))
        settings.emitters = readNamed(file, "emitters", *emitters, kEmitters);
    if (const TomlValue* place = table.optional("at")) at = readWallPoint(file, *place, scene);
    if (const TomlValue* defects = table.optional("asPrinted"))
        settings.defects = readDefects(file, *defects);
}

}  // namespace halfdisk
