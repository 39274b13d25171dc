#include "path_word.h"

#include <algorithm>

namespace halfdisk {
namespace {

/// The first `count` walls; the last of them is joined to something, so it scatters.
std::string joinedWalls(const std::string& letters, std::size_t count) {
    if (count == 0) return {};
    return letters.substr(0, count - 1) + 'D';
}

/// From the sensor outwards to the other way round.
std::string turned(std::string letters) {
    std::reverse(letters.begin(), letters.end());
    return letters;
}

std::string wordOf(const std::string& fromLight, const std::string& toSensor = {}) {
    std::string word(1, 'L');
    word += fromLight;
    word += toSensor;
    return word += 'E';
}

}  // namespace

void PathWord::follow(const PathEvent& event) {
    std::string& letters = event.carried == Carried::radiance ? sensor_ : light_;
    switch (event.kind) {
        case PathEventKind::start:
            // Of two that are joined the sensor's path begins first.
            light_.clear();
            if (event.carried == Carried::radiance) sensor_.clear();
            break;
        case PathEventKind::arrive:
            letters += 'D';
            break;
        case PathEventKind::depart:
            if (event.delta && !letters.empty()) letters.back() = 'S';
            break;
        default:
            break;
    }
}

std::string PathWord::of(const PathEvent& event) {
    follow(event);
    if (event.value == Rgb(0.0)) return {};
    const std::size_t walls = event.vertex;
    switch (event.kind) {
        case PathEventKind::asked:
            if (event.carried == Carried::power) return wordOf({});
            return wordOf(turned(joinedWalls(sensor_, walls)));
        case PathEventKind::met: {  // the lamp is the last wall that was met
            const std::size_t before = event.missed || walls == 0 ? walls : walls - 1;
            return wordOf(turned(sensor_.substr(0, before)));
        }
        case PathEventKind::joined: {
            const std::size_t s = event.s, t = event.t;
            if (s == 0) return wordOf(turned(sensor_.substr(0, t > 1 ? t - 2 : 0)));
            return wordOf(joinedWalls(light_, s - 1), turned(joinedWalls(sensor_, t > 0 ? t - 1 : 0)));
        }
        default:
            return {};
    }
}

std::string PathWord::walls() const {
    return sensor_.empty() ? light_ : turned(sensor_);
}

}  // namespace halfdisk
