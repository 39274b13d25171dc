#include "core/estimators/photons.h"

#include <algorithm>

namespace halfdisk {

double shrinking(double a, std::uint64_t pass) {
    if (a == 1.0) return 1.0;
    // Beyond some passes by Stirling's series, so that late passes take no longer.
    constexpr std::uint64_t kExact = 64;
    double factor = 1.0;
    for (std::uint64_t i = 1; i <= std::min(pass, kExact); ++i)
        factor *= (static_cast<double>(i) + a) / (static_cast<double>(i) + 1.0);
    if (pass <= kExact) return factor;
    const auto logGamma = [](double z) {
        return (z - 0.5) * std::log(z) - z + 1.0 / (12.0 * z) - 1.0 / (360.0 * z * z * z);
    };
    const auto logProduct = [&](double upTo) { return logGamma(upTo + 1.0 + a) - logGamma(upTo + 2.0); };
    return factor * std::exp(logProduct(static_cast<double>(pass)) - logProduct(kExact));
}

PhotonMap::PhotonMap(const SegmentIndex& index, const WallChains& chains, std::vector<Photon> photons,
                     const StopQuestion& stop)
    : index_(&index), chains_(&chains), photons_(std::move(photons)) {
    // Millions of small steps: a question now and then.
    std::uint64_t steps = 0;
    const auto askNowAndThen = [&] {
        constexpr std::uint64_t kSmallSteps = 4096;
        if (++steps % kSmallSteps == 0) throwIfStopped(stop);
    };
    std::sort(photons_.begin(), photons_.end(), [&](const Photon& a, const Photon& b) {
        askNowAndThen();
        return a.side != b.side ? a.side < b.side : a.along < b.along;
    });
    along_.reserve(photons_.size());
    upTo_.reserve(photons_.size() + 1);
    first_.assign(2 * std::size_t{chains.count()} + 1, photons_.size());
    // Sums of numbers that are not negative never fall, so no difference of two is negative.
    Rgb sum{0.0};
    std::size_t side = 0;
    for (std::size_t i = 0; i < photons_.size(); ++i) {
        askNowAndThen();
        for (; side <= photons_[i].side; ++side) first_[side] = i;
        along_.push_back(photons_[i].along);
        upTo_.push_back(sum);
        sum += photons_[i].power;
    }
    upTo_.push_back(sum);
}

PhotonMap::Run PhotonMap::runOf(std::uint32_t side, double from, double to) const {
    const auto begin = along_.begin() + static_cast<std::ptrdiff_t>(first_[side]);
    const auto end = along_.begin() + static_cast<std::ptrdiff_t>(first_[side + 1]);
    const auto low = std::lower_bound(begin, end, from);
    const auto high = std::upper_bound(low, end, to);
    return {static_cast<std::size_t>(low - along_.begin()), static_cast<std::size_t>(high - along_.begin())};
}

PhotonMap::Window PhotonMap::windowAt(const SidePlace& place, double radius) const {
    const std::uint32_t chain = place.side / 2;
    const double length = chains_->length(chain);
    const ChainStretch stretch = chains_->stretchAt(chain, place.along);
    const double from = std::max(stretch.from, place.along - radius),
                 to = std::min(stretch.to, place.along + radius);
    if (to - from >= length) return {{runOf(place.side, 0.0, length), {}}, length};
    Window window{{runOf(place.side, std::max(0.0, from), std::min(length, to)), {}}, to - from};
    if (from < 0.0) window.runs[1] = runOf(place.side, from + length, length);
    if (to > length) window.runs[1] = runOf(place.side, 0.0, to - length);
    return window;
}

std::uint32_t PhotonMap::count(const SidePlace& place, double radius) const {
    std::size_t count = 0;
    for (const Run& run : windowAt(place, radius).runs) count += run.last - run.first;
    return static_cast<std::uint32_t>(count);
}

Rgb PhotonMap::irradiance(const SidePlace& place, double radius) const {
    const Window window = windowAt(place, radius);
    Rgb power{0.0};
    for (const Run& run : window.runs) power += upTo_[run.last] - upTo_[run.first];
    return power / window.length;
}

Rgb PhotonMap::scattered(const Photon& photon, Vec2 toEye) const {
    const Hit hit{.segment = photon.segment,
                  .u = chains_->within(photon.segment, photon.along),
                  .front = photon.side % 2 == 0};
    const SurfacePoint at = surfaceAt(*index_, Ray{Vec2(0.0), -photon.from}, hit);
    return photon.power * evalSurface(at, photon.from, toEye);
}

Rgb PhotonMap::radiance(const SurfacePoint& at, const SidePlace& place, Vec2 toEye, double radius) const {
    // A matt flat wall forgets where its light came from: two look-ups do.
    const auto* matt = std::get_if<Diffuse>(at.material);
    if (matt && !isSmooth(index_->scene().segments[at.segment]))
        return evalDiffuse(*matt) * irradiance(place, radius);
    const Window window = windowAt(place, radius);
    Rgb sum{0.0};
    for (const Run& run : window.runs)
        for (std::size_t i = run.first; i < run.last; ++i) sum += scattered(photons_[i], toEye);
    return sum / window.length;
}

}  // namespace halfdisk
