#include "core/requirements/patch_exchange.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halfdisk {

double spectralRadiusOf(const Exchange& exchange, const Patches& patches, const Row& albedo,
                        const StopQuestion& stop) {
    constexpr int kMostSteps = 300;
    Row light(albedo.size(), 1.0);
    for (int step = 0; step < kMostSteps; ++step) {
        throwIfStopped(stop);
        Row next = exchange.arriving(light);
        double most = 0.0;
        for (std::size_t i = 0; i < next.size(); ++i) most = std::max(most, next[i] *= albedo[i]);
        if (!(most > 0.0)) return 0.0;
        for (double& value : next) value /= most;
        // The other half of an exchange between two walls alternates: the mean of two steps does not.
        double change = 0.0;
        for (std::size_t i = 0; i < next.size(); ++i) {
            next[i] = (next[i] + light[i]) / 2.0;
            change = std::max(change, std::abs(next[i] - light[i]));
        }
        light = std::move(next);
        constexpr double kSettled = 1e-6;  // everywhere: covered patches go dark while the rest stays
        if (change < kSettled) break;
    }
    // Rayleigh's quotient, with the weights l / rho for which rho F is symmetric: exact to second order.
    const Row image = exchange.arriving(light);
    double above = 0.0, below = 0.0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (albedo[i] <= 0.0) continue;
        above += patches.all()[i].length * image[i] * light[i];
        below += patches.all()[i].length * light[i] * light[i] / albedo[i];
    }
    return below > 0.0 ? above / below : 0.0;
}

}  // namespace halfdisk
