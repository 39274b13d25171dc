// Does the grid of strategies show what each brings, do its numbers add up, and does a click show one alone?
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>

#include "app/plot_tables.h"
#include "app/share_text.h"
#include "app/strategy_work.h"
#include "rig.h"

using namespace halfdisk;

namespace {

/// A disk of glass under a small lamp, and an eye: a caustic.
AppState caustic(int step) {
    return openLesson(courseLessons(), LessonRef{"both-ends", step});
}
constexpr int kStep = 6, kWithoutEye = 1;

const StrategyGrid& gridOf(const Rig& rig) {
    REQUIRE(rig.state().answer);
    REQUIRE(rig.state().answer->strategies);
    return *rig.state().answer->strategies;
}

double share(const StrategyGrid& grid, Strategy strategy, bool alone = false) {
    return grid.share(grid.film.table.placeOf(strategy), alone);
}

std::string cell(Strategy strategy) {
    return fmt::format("Stage/strategy {}, {}", strategy.s, strategy.t);
}

bool showsText(const Rig& rig, std::string_view words) {
    for (const Widget& widget : rig.session.widgets.widgets)
        if (widget.kind == WidgetKind::text && widget.name.find(words) != std::string::npos) return true;
    return false;
}

ParamValues paramsOf(const Rig& rig) {
    REQUIRE(rig.state().makers.first);
    return rig.state().makers.first->params;
}

}  // namespace

TEST_CASE("all strategies are shown, and their shares are all of the light") {
    Rig rig(caustic(kStep));
    const StrategyGrid& grid = gridOf(rig);
    CHECK(grid.complete);
    CHECK(grid.ofEye());
    CHECK(grid.white > 0.0);
    double sum = 0.0, alone = 0.0;
    for (std::size_t place = 0; place <= grid.film.table.longer(); ++place) {
        sum += grid.share(place, false);
        alone += grid.share(place, true);
    }
    CHECK(sum == doctest::Approx(1.0).epsilon(1e-9));
    CHECK(alone > 1.3);  // the same light several times
    for (std::size_t place = 0; place < grid.film.table.size(); ++place) {
        const Strategy strategy = grid.film.table[place];
        // An eye is too small to be met.
        CHECK((rig.session.widgets.find(cell(strategy)) != nullptr) == (strategy.t > 0));
        if (strategy.t == 0) CHECK(grid.share(place, true) == 0.0);
        CHECK(grid.share(place, false) <= grid.share(place, true) + 1e-12);
    }
    // The light's own path finds the caustic; what is joined at glass finds nothing.
    CHECK(share(grid, {4, 1}) > 0.5);
    CHECK(share(grid, {4, 1}) > 10.0 * share(grid, {0, 5}));
    CHECK(share(grid, {2, 3}, true) == 0.0);
    CHECK(showsText(rig, fmt::format("{:.0f}%", 100.0 * share(grid, {4, 1}))));
    CHECK(showsText(rig, "s=4 t=1"));
    CHECK(showsText(rig, "more than 6 vertices"));
}

TEST_CASE("each by itself is another picture of the same passes") {
    Rig rig(caustic(kStep));
    const auto before = rig.state().answer->strategies;
    const std::uint64_t asked = rig.state().questionId;
    CHECK_FALSE(rig.state().strategiesAlone);
    rig.driver.click("Stage/each by itself");
    CHECK(rig.state().strategiesAlone);
    CHECK(rig.state().questionId == asked);
    CHECK(rig.state().answer->strategies == before);
    CHECK(before->aloneColors != before->weightedColors);
    CHECK(showsText(rig, fmt::format("{:.0f}%", 100.0 * share(*before, {0, 3}, true))));
    CHECK(openShared(courseLessons(), shareText(rig.state())).strategiesAlone);
    rig.apply(ResetStep{});
    CHECK_FALSE(rig.state().strategiesAlone);
    CHECK_FALSE(openShared(courseLessons(), shareText(rig.state())).strategiesAlone);
}

TEST_CASE("a click shows one strategy alone, another all again, and the grid stays") {
    Rig rig(caustic(kStep));
    const auto before = rig.state().answer->strategies;
    rig.driver.click(cell({4, 1}));
    rig.settle();
    CHECK(paramsOf(rig) == ParamValues{4, 1, 1, 0, 0});
    CHECK(rig.state().answer->strategies == before);
    rig.driver.click("Stage/each by itself");
    rig.driver.click(cell({0, 3}));
    rig.settle();
    CHECK(paramsOf(rig) == ParamValues{0, 3, 0, 0, 0});
    // What the eye sees now is what the grid tells of it.
    const StrategyGrid& grid = gridOf(rig);
    double sum = 0.0;
    const auto& strip = rig.state().answer->pictures.eye->film.pixels;
    for (const Rgb& mean : strip.mean) sum += gray(mean);
    const std::size_t place = grid.film.table.placeOf({0, 3});
    const double mean = sum / static_cast<double>(strip.size()),
                 error = gray(grid.film.aloneMeans[place].standardError());
    CHECK(std::abs(mean - gray(grid.film.aloneMeans.mean[place])) < 8.0 * error);
    rig.driver.click(cell({0, 3}));
    CHECK(paramsOf(rig) == initialValues(*findEstimator("bidirectional")));
}

TEST_CASE("where the parameters are locked a click does nothing") {
    Rig rig(caustic(kWithoutEye));
    rig.apply(SetView{View::strategies, true});
    rig.settle();
    const Makers makers = rig.state().makers;
    rig.driver.click(cell({1, 2}));
    CHECK(rig.state().makers == makers);
    rig.apply(UnlockAll{true});
    rig.driver.click(cell({1, 2}));
    CHECK_FALSE(rig.state().makers == makers);
}

TEST_CASE("without an eye it is the light along P's wall, which the light's own paths meet") {
    Rig rig("controls:1");
    REQUIRE_FALSE(rig.state().scene->scene.eye);
    rig.apply(UnlockAll{true});
    rig.apply(SetView{View::code, false});
    rig.apply(SetView{View::strategies, true});
    rig.settle();
    const auto first = rig.state().answer->strategies;
    REQUIRE(first);
    CHECK_FALSE(first->ofEye());
    CHECK(rig.session.widgets.find(cell({2, 0})) != nullptr);
    CHECK(share(*first, {2, 0}) > 0.0);
    CHECK(share(*first, {2, 0}, true) == doctest::Approx(share(*first, {1, 1}, true)).epsilon(0.05));
    // Along the same wall it stays; another wall has another one.
    rig.apply(MovePoint{{rig.state().at.segment, 0.9}});
    rig.settle();
    CHECK(rig.state().answer->strategies == first);
    rig.apply(MovePoint{{rig.state().at.segment + 1, 0.5}});
    rig.settle();
    CHECK(rig.state().answer->strategies != first);
    // No mirrors: no longer paths than the depth allows.
    Settings settings = rig.state().settings;
    settings.maxDepth = 1;
    rig.apply(SetSettings{settings});
    rig.settle();
    CHECK(gridOf(rig).longest == 3);
    CHECK_FALSE(gridOf(rig).hasLonger);
    CHECK(rig.session.widgets.find(cell({0, 4})) == nullptr);
    rig.apply(SetView{View::strategies, false});
    rig.settle();
    CHECK(rig.session.widgets.find(cell({2, 0})) == nullptr);
}

TEST_CASE("the strategies follow as many skins of glass in a row as the maker") {
    const AppState state = caustic(kStep);
    LightQuestion asked;
    asked.scene = state.scene;
    asked.at = state.at;
    asked.settings = state.settings;
    asked.makers.first = makerOf("bidirectional");
    const std::atomic<bool> never{false};
    const auto cut = [&] {
        StrategyWork work(asked, never);
        REQUIRE(work.addBatch());
        return work.grid()->film.whole.counts.cut;
    };
    const std::uint64_t usual = cut();
    StrategyWork other(asked, never);
    asked.makers.first->specular = 0;
    CHECK(cut() > usual);
    CHECK_FALSE(other.answers(asked));
}

TEST_CASE("a batch that is called off adds nothing, and the next one is what it would have been") {
    const AppState state = caustic(kStep);
    LightQuestion asked;
    asked.scene = state.scene;
    asked.at = state.at;
    asked.settings = state.settings;
    asked.pictures = state.show & kPictureSet;
    asked.makers = state.makers;
    std::atomic<bool> cancelled{false}, never{false};
    StrategyWork work(asked, cancelled), undisturbed(asked, never);
    for (StrategyWork* each : {&work, &undisturbed}) REQUIRE(each->addBatch());
    const auto before = work.grid();
    cancelled = true;
    CHECK_FALSE(work.addBatch());
    CHECK(work.grid() == before);
    cancelled = false;
    for (StrategyWork* each : {&work, &undisturbed}) REQUIRE(each->addBatch());
    CHECK(work.grid()->film.weighted.mean == undisturbed.grid()->film.weighted.mean);
    CHECK(work.grid()->film.whole.passes > before->film.whole.passes);
    // It ends by itself.
    int batches = 2;
    for (; !work.grid()->complete && batches < 100; ++batches) REQUIRE(work.addBatch());
    CHECK(batches < 40);
    // The maker's own s and t are not asked; its heuristic is.
    LightQuestion other = asked;
    other.makers.first->params = {4, 1, 0, 0, 0};
    CHECK(work.answers(other));
    other.makers.first->params[3] = 1;
    CHECK_FALSE(work.answers(other));
}

TEST_CASE("its table has a row for each strategy and one for each of its pixels") {
    Rig rig(caustic(kStep));
    const std::string table = strategiesTable(rig.state());
    const auto lines = std::count(table.begin(), table.end(), '\n');
    const auto pixels = static_cast<std::ptrdiff_t>(gridOf(rig).film.pixels());
    CHECK(lines == 1 + (2 + 3 + 4 + 5 + 6) * (1 + pixels));
    AppState none = rig.state();
    none.answer.reset();
    const std::string head = strategiesTable(none);
    CHECK(std::count(head.begin(), head.end(), '\n') == 1);
}
