#include "agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/quadrature.h"
#include "lessons/scene_file.h"

namespace halfdisk::test {
namespace {

// Of the standard normal, two-sided: the z whose tail is p.
double thresholdFor(double p) {
    double low = 0.0, high = 40.0;
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        (normalTail(middle) > p ? low : high) = middle;
    }
    return high;
}

constexpr double kFalseAlarm = 1e-4;

}  // namespace

std::uint32_t Stage::wall(const std::string& wallName) const {
    const auto found = std::find(scene.segmentNames.begin(), scene.segmentNames.end(), wallName);
    if (found == scene.segmentNames.end()) throw std::runtime_error(name + " has no wall " + wallName);
    return static_cast<std::uint32_t>(found - scene.segmentNames.begin());
}

Stage readStage(const std::string& name, std::uint32_t finer) {
    Stage stage;
    stage.name = name;
    SceneDescription description = loadScene(std::string(HALFDISK_TEST_SCENES) + "/" + name + ".toml");
    for (Shape& shape : description.shapes)
        std::visit(
            [&](auto& geometry) {
                if constexpr (requires { geometry.segments; }) geometry.segments *= finer;
            },
            shape.geometry);
    stage.scene = expandScene(description);
    return stage;
}

std::vector<Sensor> sensorsOf(const Stage& stage) {
    const std::uint32_t floor = stage.wall("floor");
    Vec2 low(kInfinity), high(-kInfinity);
    for (const Segment& wall : stage.scene.segments) {
        low = glm::min(low, glm::min(wall.a, wall.b));
        high = glm::max(high, glm::max(wall.a, wall.b));
    }
    // The field keeps off the walls' lines by a little, so that no cell has an edge in one.
    if (high.y - low.y < 0.5) high.y = low.y + 1.0;
    return {Probe{shadedPointOn(*stage.index, floor, 0.37)}, EyeStrip{stage.scene.eye.value(), 6},
            Profile{{floor}, 6}, Field{low + 0.01, high - 0.013, 3, 3}};
}

ParamValues valuesOf(const EstimatorInfo& info, const std::vector<std::pair<std::string, double>>& params) {
    ParamValues values = initialValues(info);
    for (const auto& [name, value] : params) {
        const auto found =
            std::find_if(info.params.begin(), info.params.end(),
                         [&, wanted = name](const ParamInfo& param) { return param.name == wanted; });
        if (found == info.params.end()) throw std::invalid_argument("no parameter " + name);
        values[static_cast<std::size_t>(found - info.params.begin())] = value;
    }
    return values;
}

Film measure(const Stage& stage, const Sensor& sensor, const Run& run) {
    const EstimatorInfo* info = findEstimator(run.id);
    if (!info) throw std::invalid_argument("no estimator " + run.id);
    const Problem problem{*stage.index, sensor, run.maxDepth, run.maxSpecular, run.seed};
    const ParamValues values = valuesOf(*info, run.params);
    if (const std::string refusal = refusalOf(*info, problem, values); !refusal.empty())
        throw std::invalid_argument(refusal);
    RenderOptions options;
    options.passes = std::max<std::uint64_t>(1, run.samples / pixelCount(sensor));
    options.threads = run.threads;
    return render(*info->make(problem, values), sensor, options);
}

Agreement compare(const Film& a, const Film& b, std::size_t comparisons) {
    Agreement result;
    result.threshold = thresholdFor(kFalseAlarm / static_cast<double>(3 * a.pixels.size() * comparisons));
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const Rgb ea = a.pixels[i].standardError(), eb = b.pixels[i].standardError();
        for (int c = 0; c < 3; ++c) {
            const double x = a.pixels[i].mean[c], y = b.pixels[i].mean[c];
            const double error = std::hypot(ea[c], eb[c]), difference = std::abs(x - y);
            // Sums of numbers without any spread differ by their rounding.
            if (difference <= 1e-12 * std::max(std::abs(x), std::abs(y))) continue;
            const double z = error > 0.0 ? difference / error : kInfinity;
            if (z <= result.worst) continue;
            result.worst = z;
            result.where = fmt::format("pixel {} channel {}: {:.6g} +- {:.2g} against {:.6g} +- {:.2g}", i, c,
                                       x, ea[c], y, eb[c]);
        }
    }
    return result;
}

Agreement compareExact(const Film& film, const std::vector<Rgb>& exact, double err, std::size_t comparisons) {
    // As a film whose standard error is the bound.
    Film truth;
    truth.add(exact);
    truth.add(exact);
    for (Rgb& squares : truth.pixels.squares) squares = Rgb(err * err * 2.0);
    return compare(film, truth, comparisons);
}

std::vector<Rgb> exactBins(const Stage& stage, const Reference& reference, std::uint32_t wall,
                           std::size_t bins, std::size_t panels, std::uint32_t depth) {
    std::vector<Rgb> means(bins, Rgb(0.0));
    const double pieces = static_cast<double>(bins * panels);
    for (std::size_t panel = 0; panel < bins * panels; ++panel)
        for (const GaussPoint& point : kGauss8) {
            const double t = (static_cast<double>(panel) + (point.x + 1.0) / 2.0) / pieces;
            means[panel / panels] += reference.irradiance(shadedPointOn(*stage.index, wall, t), depth) *
                                     (point.weight / 2.0 / static_cast<double>(panels));
        }
    return means;
}

}  // namespace halfdisk::test
