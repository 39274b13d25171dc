#include "app/light_stages.h"

#include <algorithm>

#include "app/cloud_stages.h"
#include "app/theme.h"
#include "core/path_word.h"

namespace halfdisk {
namespace {

constexpr double kQuickRays = 1e6;
constexpr double kSamplesForHistogram = 4096;
constexpr double kRaysForHistogram = 3e6;
constexpr double kLeastRuns = 16.0;
constexpr double kMostSamplesOfErrorPlot = 4096;
constexpr double kRaysPerErrorPoint = 1.5e6;
constexpr std::uint64_t kRunsPerErrorPoint = 48;
constexpr std::size_t kMostTreeRays = 3000;
/// Of a cloud; in some 0.3 s. And of one that comes with the first picture.
constexpr std::size_t kMostCloudRays = 250'000, kMostQuickCloudRays = 20'000;

const PreparedScene& sceneOf(const LightAnswer& answer) {
    return *answer.asked.scene;
}

/// Observer that keeps what each first-bounce sample adds.
struct ContributionObserver : CancelObserver {
    std::vector<double>* values;
    std::uint32_t depth = 0;

    void enter(const ShadedPoint&, std::uint32_t at) { depth = at; }
    void leave(const ShadedPoint&, const Irradiance&) { depth = depth > 0 ? depth - 1 : 0; }
    void accumulate(std::uint32_t, const Rgb& added, const Rgb&) {
        if (depth == 0) values->push_back(gray(added));
    }
};

void runMany(LightAnswer& answer, const std::atomic<bool>& cancelled) {
    const Settings& settings = answer.asked.settings;
    const double raysPerRun = raysPerRepeat(sceneOf(answer).index, settings);
    const double runs = std::min(std::max(kSamplesForHistogram / settings.samples, kLeastRuns),
                                 kRaysForHistogram / raysPerRun);
    EstimateOptions options;
    options.repeats = static_cast<std::uint64_t>(std::clamp(runs, 1.0, 256.0));
    options.cancelled = &cancelled;
    const Estimate many = estimateIrradiance(sceneOf(answer).index, answer.point, settings, options);
    answer.runs = many.repeats;
    answer.histogramOf.clear();
    ContributionObserver observer{{{}, &cancelled}, &answer.histogramOf};
    std::uint64_t rays = 0;
    for (std::uint64_t run = 0; run < options.repeats && observer.keepGoing(); ++run)
        gatherOnce(sceneOf(answer).index, answer.point, settings, run, SampleRange::all(settings.samples),
                   observer, rays);
}

/// What each first-bounce sample gives by itself: its half-disk ray, also kept in `contributions`, and its
/// points on lights.
Statistics ownSamples(const Record& record, std::uint32_t N, std::vector<Rgb>& contributions) {
    std::vector<Rgb> whole(N, Rgb(0.0));
    for (const Event& event : record.events) {
        if (event.depth != 0 || event.n >= N) continue;
        if (event.kind == EventKind::accumulate) contributions.push_back(event.value);
        if (event.kind == EventKind::accumulate) whole[event.n] += event.value;
        if (event.kind == EventKind::light && event.segment != kNoSegment)
            whole[event.n] += event.value * static_cast<double>(N);
    }
    Statistics own;
    for (const Rgb& value : whole) own.add(value);
    return own;
}

RecordSummary summaryOf(const Record& record) {
    RecordSummary summary;
    for (std::uint32_t i = 0; i < record.events.size(); ++i) {
        const Event& event = record.events[i];
        if (event.depth == 0) summary.atP.push_back(i);
        if (event.kind != EventKind::arrival) continue;
        if (isFinite(event.value)) summary.brightest = std::max(summary.brightest, gray(event.value));
        if (event.depth == 0) continue;
        if (summary.deeper.size() < kMostTreeRays) summary.deeper.push_back(i);
    }
    return summary;
}

std::vector<SampleRow> rowsOf(const Record& record, const RecordSummary& summary, std::uint32_t N) {
    std::vector<SampleRow> rows;
    SampleRow row;
    for (const std::uint32_t i : summary.atP) {
        const Event& event = record.events[i];
        if (event.kind == EventKind::light) {
            rows.push_back(
                {i + 1, event.n, event.segment, SampleRow::Kind::light, 0.0, Rgb(0.0), event.value});
            continue;
        }
        if (event.kind == EventKind::sample) row = {i, event.n};
        if (event.kind == EventKind::sample) row.theta = event.theta;
        if (event.kind == EventKind::arrival) row.brings = event.value;
        if (event.kind != EventKind::accumulate) continue;
        row.event = i + 1;
        row.segment = event.segment;
        row.adds = event.value / static_cast<double>(N);
        rows.push_back(row);
    }
    return rows;
}

/// A row for each path, or for each two that are joined.
std::vector<SampleRow> rowsOf(const PathRun& run, Run whose) {
    std::vector<SampleRow> rows;
    PathWord word;
    double most = 0.0;  // of one find of this row
    for (std::size_t i = 0; i < run.record.events.size(); ++i) {
        const PathEvent& event = run.record.events[i];
        const std::uint32_t number = whose == Run::bidirectional ? event.path / 2 : event.path;
        auto known = rows.rbegin();  // a path may go on after those that branched off it
        while (known != rows.rend() && known->number > number) ++known;
        if (known == rows.rend() || known->number != number) {
            rows.push_back({i, number, kNoSegment, SampleRow::Kind::path});
            known = rows.rbegin();
            most = 0.0;
        }
        SampleRow& row = *known;
        row.event = i + 1;
        row.adds += event.value / static_cast<double>(run.divisor);
        const std::string found = word.of(event);
        if (whose == Run::photonMap) continue;  // what is looked up came by many ways
        if (!found.empty()) ++row.finds;
        if (gray(event.value) > most) row.word = found;
        if (row.finds == 0) row.word = word.walls();
        most = std::max(most, gray(event.value));
    }
    return rows;
}

/// One point of the error plot; nothing if it would take too many rays.
std::optional<ErrorPoint> measureError(const LightAnswer& answer, std::uint32_t N,
                                       const std::atomic<bool>& cancelled) {
    Settings settings = answer.asked.settings;
    settings.samples = N;
    const SegmentIndex& index = sceneOf(answer).index;
    if (raysPerRepeat(index, settings) * static_cast<double>(kRunsPerErrorPoint) >
        answer.asked.effort * kRaysPerErrorPoint)
        return std::nullopt;
    double sum = 0.0, squares = 0.0;
    NoObserver observer;
    std::uint64_t rays = 0;
    for (std::uint64_t run = 0; run < kRunsPerErrorPoint; ++run) {
        if (cancelled.load(std::memory_order_relaxed)) return std::nullopt;
        const Irradiance E =
            gatherOnce(index, answer.point, settings, run, SampleRange::all(N), observer, rays);
        const double error = gray(E.total() - *answer.exact);
        sum += error * error;
        squares += error * error * error * error;
    }
    const double count = static_cast<double>(kRunsPerErrorPoint);
    const double meanSquare = sum / count, rms = std::sqrt(meanSquare);
    const double variance = std::max(0.0, squares / count - meanSquare * meanSquare) / count;
    return ErrorPoint{static_cast<double>(N), rms, rms > 0.0 ? std::sqrt(variance) / (2.0 * rms) : 0.0};
}

/// Each defect by itself, by many samples.
void measureDamage(LightAnswer& answer, const std::atomic<bool>& cancelled) {
    const double exact = gray(*answer.exact);
    if (exact <= 0.0) return;
    Settings settings = answer.asked.settings;
    settings.defects = {};
    const double runs = std::min(400.0, kRaysPerErrorPoint / raysPerRepeat(sceneOf(answer).index, settings));
    EstimateOptions options;
    options.repeats = static_cast<std::uint64_t>(std::max(4.0, answer.asked.effort * runs));
    options.cancelled = &cancelled;
    for (const Named<Defect>& defect : kDefects) {
        settings.defects = {};
        settings.defects.set(defect.value, true);
        const Estimate many = estimateIrradiance(sceneOf(answer).index, answer.point, settings, options);
        answer.damage.push_back({defect.value, gray(many.irradiance()) / exact - 1.0,
                                 gray(many.repeats.standardError()) / exact});
    }
}

}  // namespace

bool isQuick(const LightQuestion& question) {
    return raysPerRepeat(question.scene->index, question.settings) < kQuickRays;
}

void recordRun(LightAnswer& answer, const std::atomic<bool>& cancelled) {
    const LightQuestion& asked = answer.asked;
    const PreparedScene& scene = *asked.scene;
    answer.point = shadedPointOn(scene.index, asked.at.segment, asked.at.t);
    const double rays = raysPerRepeat(scene.index, asked.settings);
    if (rays > kMostRaysPerRun) {
        answer.tooManyRays = true;
        answer.rays = rays < 1e18 ? static_cast<std::uint64_t>(rays) : UINT64_MAX;
        return;
    }
    constexpr std::size_t kEventLimit = 100'000;
    TreeRecorder recorder(kEventLimit, asked.wantsTree ? kMostCloudRays : 0, &cancelled);
    answer.estimate = gatherOnce(scene.index, answer.point, asked.settings, 0,
                                 SampleRange::all(asked.settings.samples), recorder, answer.rays);
    if (asked.settings.defects != DefectSet{}) {
        Settings corrected = asked.settings;
        corrected.defects = {};
        CancelObserver observer{{}, &cancelled};
        std::uint64_t uncounted = 0;
        answer.corrected = gatherOnce(scene.index, answer.point, corrected, 0,
                                      SampleRange::all(corrected.samples), observer, uncounted);
    }
    const bool diffuse = std::holds_alternative<Diffuse>(scene.index.material(answer.point.segment));
    answer.radiance.reset();
    if (diffuse)
        answer.radiance =
            outgoingRadiance(scene.index, answer.point, answer.estimate.total(), asked.settings.defects);
    auto record = std::make_shared<Record>(recorder.take());
    record->rays = answer.rays;
    const Statistics own = ownSamples(*record, asked.settings.samples, answer.contributions);
    answer.nonFinite = own.nonFinite;
    if (asked.settings.sampler != Sampler::stratified && own.count > 1)
        answer.standardError = own.standardError();
    answer.summary = summaryOf(*record);
    answer.summary.deeperCount = recorder.deeperCount();
    if (asked.wantsTree && asked.run == Run::castRay && recorder.deeperCount() > kMostTreeRays)
        answer.treeLines = std::make_shared<const std::vector<CloudLine>>(
            recorder.lines(answer.summary.brightest, 8.0 * glm::length(scene.bounds.size())));
    answer.rows = std::make_shared<const std::vector<SampleRow>>(
        rowsOf(*record, answer.summary, asked.settings.samples));
    answer.record = std::move(record);
}

bool hasQuickCloud(const LightAnswer& answer) {
    return answer.treeLines && answer.treeLines->size() <= kMostQuickCloudRays;
}

void makeTreeCloud(LightAnswer& answer, const std::atomic<bool>& cancelled) {
    if (!answer.treeLines) return;
    const Palette palette;
    answer.tree = cloudOf(*answer.treeLines, answer.asked.scene->bounds, {palette.rayDark, palette.rayBright},
                          cancelled);
    answer.treeLines.reset();
}

void recordPathRun(LightAnswer& answer, const std::atomic<bool>& cancelled) {
    const LightQuestion& asked = answer.asked;
    if (asked.run == Run::castRay) return;
    const std::string_view id = nameOf(kRuns, asked.run);
    const EstimatorInfo& info = *findEstimator(id);
    const std::optional<Maker>& maker =
        asked.pixel && asked.pixelOf == Side::second ? asked.makers.second : asked.makers.first;
    const bool sameMaker = maker && maker->estimator == id;
    const ParamValues params = sameMaker ? maker->params : initialValues(info);
    const auto strip = asked.pixel ? eyeStripOf(asked.scene->scene) : std::nullopt;
    Settings settings = asked.settings;
    // A pixel's paths are those of the strip.
    if (strip && sameMaker) {
        settings.maxDepth = maker->depth.value_or(settings.maxDepth);
        settings.maxSpecular = maker->specular.value_or(settings.maxSpecular);
    }
    try {
        answer.pathRun = std::make_shared<const PathRun>(recordPaths(
            info, asked.scene->index, strip.value_or(Probe{answer.point}), strip ? *asked.pixel : 0, settings,
            params, [&] { return cancelled.load(std::memory_order_relaxed); }));
        answer.rows = std::make_shared<const std::vector<SampleRow>>(rowsOf(*answer.pathRun, asked.run));
    } catch (const Stopped&) {
        // A newer question waits: nobody will ask for this run.
    }
}

void refine(LightAnswer& answer, ReferenceCache& references, const std::atomic<bool>& cancelled,
            const std::function<void()>& publish) {
    if (!answer.tooManyRays) {
        findExact(answer, references, cancelled);
        if (cancelled) return;
        publish();
        runMany(answer, cancelled);
        if (cancelled) return;
        publish();
        for (double N = 1; answer.exact && N <= kMostSamplesOfErrorPlot; N *= 2) {
            const auto point = measureError(answer, static_cast<std::uint32_t>(N), cancelled);
            if (cancelled) return;
            if (!point) break;
            answer.errors.push_back(*point);
        }
        if (answer.exact && answer.asked.wantsDamage) measureDamage(answer, cancelled);
        if (cancelled) return;
    }
    answer.pointComplete = true;
    publish();
}

}  // namespace halfdisk
