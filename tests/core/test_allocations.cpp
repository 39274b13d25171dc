// Does any estimator ask for memory at every ray or path? Counts every call of operator new in a pass, so it
// is a program of its own.
#include <doctest/doctest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "agreement.h"

namespace {

// The one place that a replaced operator new can count in.
std::atomic<std::uint64_t> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
    ++allocations;
    const std::size_t whole = (size + alignment - 1) / alignment * alignment;
    if (void* memory = std::aligned_alloc(alignment, whole == 0 ? alignment : whole)) return memory;
    throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) {
    return counted(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

Stage stageOf(const std::string& name) {
    Stage stage = readStage(name);
    stage.index = std::make_unique<SegmentIndex>(stage.scene);
    return stage;
}

/// `size` times as many pixels, where there are several.
std::vector<Sensor> sensorsOfSize(const Stage& stage, std::uint32_t size) {
    std::vector<Sensor> sensors = sensorsOf(stage);
    std::get<EyeStrip>(sensors[1]).width = 20 * size;
    std::get<Profile>(sensors[2]).bins = 20 * size;
    std::get<Field>(sensors[3]).width = 4 * size;
    std::get<Field>(sensors[3]).height = 5;
    const Eye& eye = *stage.scene.eye;
    sensors.push_back(Look{eye.position, eye.direction});
    return sensors;
}

struct Asked {
    const char* id;
    const char* paths = nullptr;  ///< the parameter that tells how many paths a pass has besides its pixels'
    double few = 0.0;
    std::uint32_t maxDepth = 3;
};
constexpr Asked kAsked[]{{"cast-ray", "samples", 3, 2},
                         {"path"},
                         {"light", "paths", 200},
                         {"bidirectional"},
                         {"photon-map", "photons", 200},
                         {"virtual-lights", "paths", 20},
                         {"radiosity"},
                         {"closed-form", nullptr, 0, 0}};

/// Calls of operator new in a pass, the first pass left out. Empty where the estimator refuses.
std::optional<std::uint64_t> allocationsOf(const Stage& stage, const Sensor& sensor, const Asked& asked,
                                           double size) {
    const EstimatorInfo& info = *findEstimator(asked.id);
    const Problem problem{.index = *stage.index, .sensor = sensor, .maxDepth = asked.maxDepth};
    std::vector<std::pair<std::string, double>> params;
    if (asked.paths) params.push_back({asked.paths, asked.few * size});
    const ParamValues values = valuesOf(info, params);
    if (!refusalOf(info, problem, values).empty()) return std::nullopt;
    const auto estimator = info.make(problem, values);
    Picture picture(pixelCount(sensor), Rgb(0.0));
    Counts counts;
    estimator->addPass(0, picture, counts);
    const std::uint64_t before = allocations;
    estimator->addPass(1, picture, counts);
    return allocations - before;
}

}  // namespace

TEST_CASE("allocations: the count sees them") {
    const std::uint64_t before = allocations;
    std::vector<int> numbers(100);
    CHECK(allocations == before + 1);
    numbers.resize(1000);
    CHECK(allocations == before + 2);
}

TEST_CASE(
    "allocations: a pass of ten times the paths and pixels asks for memory no more often but by growth") {
    // Of a vector that grows to ten times its size, four times; no estimator fills more than a few.
    constexpr std::uint64_t kGrowth = 24;
    int asked = 0;
    for (const char* name : {"mixed", "glossy_wall", "two_patches", "closed_room"}) {
        const Stage stage = stageOf(name);
        const std::vector<Sensor> small = sensorsOfSize(stage, 1), large = sensorsOfSize(stage, 10);
        for (const Asked& one : kAsked)
            for (std::size_t i = 0; i < small.size(); ++i) {
                const auto few = allocationsOf(stage, small[i], one, 1.0),
                           many = allocationsOf(stage, large[i], one, 10.0);
                if (!few || !many) continue;
                ++asked;
                INFO(name << " " << one.id << " " << kSensorNames[small[i].index()] << ": " << *few << " and "
                          << *many);
                CHECK(*many <= *few + kGrowth);
                // Twenty pixels or paths at least, but for a single point.
                CHECK(*few <= 40);
            }
    }
    CHECK(asked > 60);
}
