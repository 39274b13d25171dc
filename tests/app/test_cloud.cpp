// Is the picture of many lines right? Lengths, symmetry, edges, order, and what it costs.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>

#include "app/cloud_stages.h"
#include "app/ray_cloud.h"
#include "app/sheet.h"
#include "app/textures.h"
#include "core/rng.h"
#include "rig.h"

using namespace halfdisk;

namespace {

const Bounds kRoom{{-2.0, 1.0}, {4.0, 4.0}};
constexpr std::uint32_t kSide = 600;  // 1 cm

CloudSums sums(const std::vector<CloudLine>& lines, std::uint32_t side = kSide) {
    return *sumUp(lines, kRoom, side, {});
}

std::uint32_t at(const CloudSums& sums, std::uint32_t x, std::uint32_t y, int color = 0) {
    return static_cast<std::uint32_t>(sums.at(x, y) >> (32 * color));
}

/// m of lines of weight 1.
double lengthIn(const CloudSums& sums, int color) {
    double all = 0.0;
    for (std::uint32_t y = 0; y < sums.height; ++y)
        for (std::uint32_t x = 0; x < sums.width; ++x) all += at(sums, x, y, color);
    return sums.width > 0 ? all / CloudSums::kUnit * sums.area.size().x / sums.width : 0.0;
}

std::vector<CloudLine> randomLines(std::size_t count) {
    const Rng rng(7, 0);
    std::vector<CloudLine> lines;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto place = [&](std::uint32_t end) {
            return Vec2(-3.0 + 8.0 * rng.uniform(i, 2 * end), 5.0 * rng.uniform(i, 2 * end + 1));
        };
        lines.push_back({place(0), place(1), {0.3f, 0.4f}});
    }
    return lines;
}

}  // namespace

TEST_CASE("a line covers as much as it is long, in its colours, whatever its direction") {
    for (int k = 0; k < 48; ++k) {
        const double angle = 2.0 * kPi * (k + 0.13) / 48.0;
        const Vec2 middle{1.0, 2.5}, half = 1.2 * Vec2(std::cos(angle), std::sin(angle));
        const CloudSums seen = sums({{middle - half, middle + half, {1.0f, 0.25f}}});
        CHECK(lengthIn(seen, 0) == doctest::Approx(2.4).epsilon(0.002));
        CHECK(lengthIn(seen, 1) == doctest::Approx(0.6).epsilon(0.002));
    }
}

TEST_CASE("a line lies where it is said to lie, rows from the top") {
    // Along the middles of the cells of the 30th row, 0.295 m below the upper edge.
    const CloudSums seen = sums({{{-1.0, 3.705}, {2.0, 3.705}}});
    REQUIRE(seen.width == 600);
    REQUIRE(seen.height == 300);
    const auto whole = static_cast<std::uint32_t>(CloudSums::kUnit);
    CHECK(at(seen, 200, 29) == doctest::Approx(whole).epsilon(0.001));
    CHECK(at(seen, 200, 28) <= 1);
    CHECK(at(seen, 200, 30) <= 1);
    CHECK(at(seen, 99, 29) == 0);
    CHECK(at(seen, 400, 29) == 0);
}

TEST_CASE("a mirrored line gives the mirrored picture, and a turned one the same") {
    const std::vector<CloudLine> lines{{{-1.7, 1.3}, {2.9, 3.1}}, {{0.2, 1.1}, {0.4, 3.9}}};
    std::vector<CloudLine> mirrored = lines, turned = lines;
    for (CloudLine& line : mirrored) {
        line.from.x = 2.0 - line.from.x;
        line.to.x = 2.0 - line.to.x;
    }
    for (CloudLine& line : turned) std::swap(line.from, line.to);
    const CloudSums seen = sums(lines), other = sums(mirrored);
    CHECK(sums(turned).cells == seen.cells);
    std::int64_t worst = 0;
    for (std::uint32_t y = 0; y < seen.height; ++y)
        for (std::uint32_t x = 0; x < seen.width; ++x)
            worst = std::max(worst, std::abs(std::int64_t{at(seen, x, y)} -
                                             std::int64_t{at(other, seen.width - 1 - x, y)}));
    // A place across the line is told in 256 parts.
    CHECK(worst <= static_cast<std::int64_t>(1.5 * CloudSums::kUnit / 256.0) + 1);
}

TEST_CASE("lines are cut at the edges of the picture, and those that have no end are left out") {
    CHECK(lengthIn(sums({{{-50.0, 2.0}, {60.0, 2.0}}}), 0) == doctest::Approx(6.0).epsilon(0.002));
    CHECK(lengthIn(sums({{{1.0, -1e9}, {1.0, 1e9}}}), 0) == doctest::Approx(3.0).epsilon(0.002));
    CHECK(lengthIn(sums({{{-50.0, 5.0}, {60.0, 5.0}}}), 0) == 0.0);
    CHECK(lengthIn(sums({{{1.0, 2.0}, {1.0, 2.0}}}), 0) == 0.0);
    // Along the edges, where half of it is outside, it does not run into other rows.
    const CloudSums edge = sums({{{-2.0, 1.0}, {4.0, 1.0}}, {{4.0, 1.0}, {4.0, 4.0}}});
    CHECK(at(edge, 300, 298) == 0);
    CHECK(at(edge, 0, 150) == 0);
    CHECK(at(edge, 300, 299) > 0);
    const double no = std::numeric_limits<double>::quiet_NaN(), far = kInfinity;
    for (const Vec2 end : {Vec2(no, 2.0), Vec2(1.0, no), Vec2(far, 2.0), Vec2(far, -far), Vec2(no, far)}) {
        CHECK(lengthIn(sums({{{0.0, 2.0}, end}}), 0) == 0.0);
        CHECK(lengthIn(sums({{end, {0.0, 2.0}}}), 0) == 0.0);
    }
    const float none = std::numeric_limits<float>::quiet_NaN();
    CHECK(lengthIn(sums({{{0.0, 2.0}, {1.0, 2.0}, {none, 0.0f}}}), 0) == 0.0);
}

TEST_CASE("the order of the lines does not matter to any bit") {
    std::vector<CloudLine> lines = randomLines(3000);
    const CloudSums seen = sums(lines);
    CHECK(lengthIn(seen, 0) > 100.0);
    std::reverse(lines.begin(), lines.end());
    std::rotate(lines.begin(), lines.begin() + 1234, lines.end());
    const CloudSums other = sums(lines);
    CHECK(seen.cells == other.cells);
    CHECK(cloudPicture(seen, {0xff0000ffu, 0xffff0000u}) == cloudPicture(other, {0xff0000ffu, 0xffff0000u}));
}

TEST_CASE("where twice as many lines lie it is denser, and never full; colours mix by weight") {
    std::vector<CloudLine> lines;
    const auto add = [&](int count, double y, std::array<float, 2> weight) {
        for (int i = 0; i < count; ++i) lines.push_back({{-1.0, y}, {3.0, y}, weight});
    };
    // In the middles of rows 49, 99, ...
    add(1, 3.505, {1.0f, 0.0f});
    add(10, 3.005, {1.0f, 0.0f});
    add(20, 2.505, {1.0f, 0.0f});
    add(10, 2.005, {0.5f, 0.5f});
    const Image picture = cloudPicture(sums(lines), {0xff0000ffu, 0xffff0000u});
    const auto pixel = [&](int row) { return picture.at(300, row); };
    const int one = pixel(49)[3], ten = pixel(99)[3], twenty = pixel(149)[3];
    CHECK(0 < one);
    CHECK(one < ten);
    CHECK(ten < twenty);
    CHECK(twenty < 255);
    // 1 - exp(-density): what shows through falls with the square.
    const auto through = [](int opacity) { return 1.0 - opacity / 255.0; };
    CHECK(through(twenty) == doctest::Approx(through(ten) * through(ten)).epsilon(0.03));
    CHECK(int{pixel(149)[0]} == twenty);  // premultiplied
    CHECK(int{pixel(149)[2]} == 0);
    CHECK(int{pixel(199)[3]} == doctest::Approx(ten).epsilon(0.02));
    CHECK(int{pixel(199)[0]} == doctest::Approx(int{pixel(199)[2]}).epsilon(0.02));
    CHECK(int{picture.at(300, 70)[3]} == 0);
}

TEST_CASE("no scene and no line makes a picture that cannot be") {
    const Bounds flat{{0.0, 1.0}, {2.0, 1.0}}, point{{1.0, 1.0}, {1.0, 1.0}};
    const std::vector<CloudLine> line{{{0.0, 1.0}, {2.0, 1.0}}};
    CHECK(sumUp(line, flat, 100, {})->height == 1);
    CHECK(sumUp(line, point, 100, {})->cells.empty());
    const Image none = cloudPicture(*sumUp(line, point, 100, {}), {0u, 0u});
    CHECK(none.rgba.empty());
    const Image empty = cloudPicture(sums({}), {0u, 0u});
    CHECK(std::all_of(empty.rgba.begin(), empty.rgba.end(), [](std::uint8_t byte) { return byte == 0; }));
}

TEST_CASE("a million lines take bounded time and memory, overflow nowhere, and can be called off") {
    const std::vector<CloudLine> same(kMostCloudLines + 1000, {{0.0, 2.005}, {0.2, 2.005}});
    const auto start = std::chrono::steady_clock::now();
    const CloudSums seen = *sumUp(same, kRoom, kCloudSide, {});
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    CHECK(seconds < 20.0);
    CHECK(seen.cells.size() <= std::size_t{kCloudSide + 2} * (kCloudSide + 2));
    CHECK(lengthIn(seen, 0) == doctest::Approx(0.2 * kMostCloudLines).epsilon(0.005));
    int looks = 0;
    CHECK_FALSE(sumUp(same, kRoom, kCloudSide, [&] { return ++looks == 3; }).has_value());
    CHECK(looks == 3);
}

namespace {

/// A rig whose tree has so many rays, and no other picture.
void showTree(Rig& rig, std::uint32_t samples, std::uint32_t depth) {
    rig.apply(SetView{View::tree, true});
    Settings settings = rig.state().settings;
    settings.samples = samples;
    settings.maxDepth = depth;
    rig.apply(SetSettings{settings});
    rig.settle();
}

std::size_t texturesOf(Rig& rig) {
    rig.host->frameWithoutDrawing([&] { frame(rig.session, rig.host->fonts(), rig.host->uiScale()); });
    return currentTextures()->entries().size();
}

}  // namespace

TEST_CASE("thousands of deeper rays are a cloud of all of them, and a picture in the export") {
    Rig rig("controls:1");
    showTree(rig, 2, 1);
    CHECK_FALSE(rig.state().answer->tree);
    CHECK(texturesOf(rig) == 0);
    showTree(rig, 16, 2);
    const LightAnswer& answer = *rig.state().answer;
    REQUIRE(answer.tree);
    CHECK(answer.tree->lines == answer.summary.deeperCount);
    CHECK(answer.tree->lines > 3000);
    CHECK_FALSE(answer.treeLines);
    CHECK(texturesOf(rig) == 1);
    Sheet sheet;
    rig.host->frameWithoutDrawing(
        [&] { frame(rig.session, rig.host->fonts(), rig.host->uiScale(), &sheet); });
    REQUIRE(sheet.find("canvas"));
    CHECK(sheet.find("canvas")->svg("", "").find("<image ") != std::string::npos);
    rig.apply(SetView{View::tree, false});
    CHECK(texturesOf(rig) == 0);
}

TEST_CASE("deeper rays beyond the record are in the cloud as well, and nobody waits for them") {
    Rig rig("controls:1");
    showTree(rig, 32, 2);
    const LightAnswer& answer = *rig.state().answer;
    REQUIRE(answer.tree);
    CHECK(answer.record->truncated);
    const auto recorded = static_cast<std::size_t>(std::count_if(
        answer.record->events.begin(), answer.record->events.end(),
        [](const Event& event) { return event.kind == EventKind::arrival && event.depth > 0; }));
    CHECK(answer.tree->lines == answer.summary.deeperCount);
    CHECK(answer.tree->lines > recorded);
}

TEST_CASE("what the recorder of the tree keeps is the same as in the record") {
    Rig rig("controls:1");
    showTree(rig, 16, 2);
    const LightAnswer& answer = *rig.state().answer;
    REQUIRE_FALSE(answer.record->truncated);
    TreeRecorder recorder(1'000'000, 1'000'000, nullptr);
    std::uint64_t rays = 0;
    const SegmentIndex& index = rig.state().scene->index;
    gatherOnce(index, answer.point, answer.asked.settings, 0, SampleRange::all(answer.asked.settings.samples),
               recorder, rays);
    const std::vector<CloudLine> lines = recorder.lines(answer.summary.brightest, 100.0);
    const Record record = recorder.take();
    std::size_t i = 0;
    for (const Event& event : record.events) {
        if (event.kind != EventKind::arrival || event.depth == 0) continue;
        REQUIRE(i < lines.size());
        const CloudLine& line = lines[i++];
        REQUIRE(line.from == event.from);
        const Vec2 to = event.missed ? event.from + 100.0 * event.direction : event.to;
        REQUIRE(glm::length(line.to - to) < 1e-9);
        const float weight = line.weight[0] + line.weight[1];
        REQUIRE(weight <= 1.0f / static_cast<float>(event.depth) + 1e-6f);
        REQUIRE((line.weight[1] > 0.0f) == (gray(event.value) > 0.0));
    }
    CHECK(i == lines.size());
    CHECK(i == answer.summary.deeperCount);
}

TEST_CASE("while the run is stepped through, no cloud tells what is still to come") {
    Rig rig("controls:1");
    showTree(rig, 16, 2);
    REQUIRE(rig.state().answer->tree);
    rig.session.state.playback.stepping = true;
    rig.session.state.playback.event = 100;
    rig.driver.frames(2);
    CHECK(texturesOf(rig) == 0);
}
