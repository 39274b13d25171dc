// Does the advisor say what the scene requires, do what the reader forces, and make pictures as it says?
#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "app/light_progress.h"
#include "app/plot_tables.h"
#include "app/share_text.h"
#include "app/state_text.h"
#include "app/trade_words.h"
#include "file_reading.h"
#include "lessons/scene_file.h"
#include "rig.h"

using namespace halfdisk;

namespace {

bool showsText(const Rig& rig, std::string_view words) {
    for (const Widget& widget : rig.session.widgets.widgets)
        if (widget.kind == WidgetKind::text && widget.name.find(words) != std::string::npos) return true;
    return false;
}

/// A scene with the advisor and the light along a wall.
AppState advised(const char* scene = "scenes/open_court.toml") {
    AppState state = openScene(courseLessons(), courseLessons() / scene);
    apply(state, SetView{View::requirements, true});
    apply(state, SetView{View::profile, true});
    return state;
}

const InstrumentAnswers& answers(const Rig& rig) {
    return rig.state().answer->instruments;
}

void choose(Rig& rig, const std::string& requirement, const std::string& option) {
    const std::string name = "Stage/" + requirement;
    rig.scrollTo(name, "Stage/bounces");
    rig.driver.click(name);
    rig.driver.frames(2);
    rig.driver.click(name + "/" + option);
    rig.settle();
}

const RequirementLine& lineOf(const std::vector<RequirementLine>& lines, RequirementId id) {
    return *std::find_if(lines.begin(), lines.end(), [&](const RequirementLine& l) { return l.id == id; });
}

}  // namespace

TEST_CASE(
    "the advisor lists every requirement with its reason, and what each part that can be left out costs") {
    Rig rig(advised());
    CHECK(showsText(rig, advice(rig.state())));
    const std::vector<RequirementLine> lines = requirementLines(rig.state());
    REQUIRE(lines.size() == kRequirements.size());
    for (const RequirementInfo& info : kRequirements) {
        CAPTURE(info.name);
        CHECK(showsText(rig, info.title));
        const RequirementLine& line = lineOf(lines, info.id);
        const Requirement& found = answers(rig).requirements->of(info.id);
        CHECK(line.reason.find(found.reason) != std::string::npos);
        CHECK(line.on == found.on);
        CHECK_FALSE(line.forced);
        const bool switched = info.kind != Switch::none;
        CHECK((rig.session.widgets.find("Stage/" + std::string(info.name)) != nullptr) == switched);
        CHECK(line.costs.empty() != switched);
        for (const std::string& cost : line.costsByTime) CHECK(cost.find("with") == 0);
    }
    REQUIRE(answers(rig).costs);
    CHECK(answers(rig).costs->complete());
    CHECK(lightIsComplete(rig.state()));
    CHECK(lightParts(rig.state()).find("requirements done") != std::string::npos);
    CHECK(everythingWords(rig.state()).find("everything") != std::string::npos);
}

TEST_CASE("a part that is forced is forced and told, what the scene needs is kept, and it can be let go") {
    Rig rig(advised());
    const auto free = answers(rig).unforced;
    REQUIRE(free);
    CHECK(answers(rig).requirements == free);
    REQUIRE_FALSE(free->plan.way.lightSampling);  // the formula does
    CHECK(rig.session.widgets.find("Stage/Force nothing") == nullptr);
    choose(rig, "light-sampling", "on");
    CHECK(rig.state().instruments.forced == std::vector<Forced>{{RequirementId::lightSampling, 1}});
    CHECK(answers(rig).unforced == free);
    REQUIRE(answers(rig).requirements);
    CHECK(answers(rig).requirements->plan.way.lightSampling);
    CHECK(answers(rig).requirements->of(RequirementId::lightSampling).ground == Ground::force);
    CHECK(showsText(rig, "forced: on"));
    CHECK(showsText(rig, "the scene: not needed"));
    REQUIRE(answers(rig).forcedCost);
    CHECK(showsText(rig, forcedWords(rig.state()).substr(0, 20)));
    choose(rig, "bounces", "3");
    CHECK(rig.state().instruments.forced.size() == 2);
    CHECK(answers(rig).requirements->plan.maxDepth == 3);
    choose(rig, "light-sampling", "as needed");
    CHECK(rig.state().instruments.forced == std::vector<Forced>{{RequirementId::bounces, 3}});
    rig.driver.click("Stage/Force nothing");
    rig.settle();
    CHECK(rig.state().instruments.forced.empty());
    CHECK(answers(rig).requirements == free);
    CHECK(forcedWords(rig.state()).empty());
}

TEST_CASE("Do it so makes the pictures by the plan, and says when they are") {
    Rig rig(advised());
    CHECK_FALSE(rig.state().makers.first.has_value());
    const Plan plan = answers(rig).requirements->plan;
    rig.driver.click("Stage/Do it so");
    rig.settle();
    REQUIRE(rig.state().makers.first);
    CHECK(rig.state().makers.first->estimator == plan.estimator->id);
    CHECK(rig.state().makers.first->params == plan.params);
    CHECK(rig.state().makers.first->depth == std::optional(plan.maxDepth));
    CHECK(rig.state().answer->asked.makers == rig.state().makers);
    CHECK(rig.state().answer->pictures.profile->refusal.empty());
    CHECK_FALSE(rig.driver.get("Stage/Do it so").enabled);
    // Another plan can be done again.
    choose(rig, "bounces", "2");
    CHECK(rig.driver.get("Stage/Do it so").enabled);
    rig.driver.click("Stage/Do it so");
    rig.settle();
    CHECK(rig.state().makers.first->depth == 2u);
}

TEST_CASE("Do it so follows as many mirrors in a row as the plan, in the picture and in the trade") {
    // Light goes round between perfect mirrors for long.
    AppState state = openDescribed(courseLessons(), parseScene(R"(
[material.plate]
type = "diffuse"
albedo = 0.8
[material.silver]
type = "mirror"
reflectance = 1.0
[[segment]]
name = "plate"
a = [0.2, 0.1]
b = [0.5, 0.1]
material = "plate"
[[segment]]
name = "lamp"
a = [1.05, 1.9]
b = [0.95, 1.9]
emission = 1.0
[[polygon]]
name = "box"
points = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]
material = "silver"
)",
                                                               "mirrors"));
    for (const View view : {View::requirements, View::profile}) apply(state, SetView{view, true});
    Rig rig(std::move(state));
    const auto shareCut = [&] {
        const Counts& counts = rig.state().answer->pictures.profile->film.counts;
        return static_cast<double>(counts.cut) / static_cast<double>(counts.paths);
    };
    const std::uint32_t planned = answers(rig).requirements->plan.maxSpecular;
    CHECK(planned > kMaxSpecularInfo.initial);
    const double cutBefore = shareCut();
    CHECK(cutBefore > 0.05);
    rig.driver.click("Stage/Do it so");
    rig.settle();
    REQUIRE(rig.state().makers.first);
    CHECK(rig.state().makers.first->specular == planned);
    CHECK(shareCut() < 0.2 * cutBefore);
    std::istringstream told(stateText(rig.state()));  // in lines of some length
    std::string words;
    for (std::string word; told >> word;) words += word + ' ';
    CHECK(words.find(fmt::format("; {} mirrors or skins", planned)) != std::string::npos);
    choose(rig, "specular", "off");
    rig.driver.click("Stage/Do it so");
    rig.settle();
    CHECK(rig.state().makers.first->specular == 0u);
    CHECK(shareCut() > cutBefore);

    // The trade is measured with as many, and so are the pictures that its settings make.
    rig.apply(SetView{View::trade, true});
    rig.settle();
    const auto trade = answers(rig).trade;
    REQUIRE(trade);
    CHECK(trade->reference.find("after 0 mirror") != std::string::npos);
    const auto maker = makerOf(rig.state(), *trade, 0);
    REQUIRE(maker);
    CHECK(maker->specular == 0u);
    rig.apply(PickTrade{0, *maker});
    rig.settle();
    CHECK(answers(rig).trade->reference == trade->reference);
    CHECK(cellOnStage(rig.state(), *answers(rig).trade) == std::size_t{0});
    rig.apply(SetMakers{});
    rig.settle();
    CHECK(answers(rig).trade->reference.find("after 32 mirror") != std::string::npos);
}

TEST_CASE("the picture that the plan is about is shown") {
    AppState state = advised();
    apply(state, SetView{View::profile, false});
    Rig rig(std::move(state));
    rig.driver.click("Stage/Do it so");
    rig.settle();
    CHECK(rig.state().shows(View::profile));
    CHECK(rig.state().answer->pictures.profile);
}

TEST_CASE("the tolerance is typed, and a small one asks for what a large one leaves out") {
    Rig rig(advised());
    const std::uint32_t few = answers(rig).requirements->plan.maxDepth;
    rig.driver.typeNumber("Stage/tolerance", "0.05");
    rig.settle();
    CHECK(rig.state().instruments.tolerance == doctest::Approx(0.0005));
    CHECK(answers(rig).requirements->tolerance == rig.state().instruments.tolerance);
    CHECK(answers(rig).requirements->plan.maxDepth > few);
    rig.driver.typeNumber("Stage/tolerance", "0");
    CHECK(rig.state().instruments.tolerance == kLeastTolerance);
}

TEST_CASE("what is measured stays while P moves along its wall, and on another wall it is asked anew") {
    Rig rig(advised());
    const auto requirements = answers(rig).requirements;
    const auto costs = answers(rig).costs;
    rig.apply(MovePoint{{rig.state().at.segment, 0.9}});
    rig.settle();
    CHECK(answers(rig).requirements == requirements);
    CHECK(answers(rig).costs == costs);
    rig.apply(MovePoint{{rig.state().at.segment == 0 ? 1u : 0u, 0.5}});
    rig.settle();
    CHECK(answers(rig).requirements != requirements);
}

TEST_CASE("what cannot be forced together is refused in words, and the switches stay") {
    AppState state = advised();
    InstrumentSettings settings = state.instruments;
    force(settings, RequirementId::mis, 1);
    force(settings, RequirementId::lightSampling, 0);
    apply(state, SetInstruments{settings});
    Rig rig(std::move(state));
    CHECK(answers(rig).requirements == nullptr);
    CHECK(showsText(rig, "There is no plan"));
    CHECK(requirementLines(rig.state()).size() == kRequirements.size());
    CHECK(lightIsComplete(rig.state()));
    CHECK_FALSE(rig.driver.get("Stage/Do it so").enabled);
    rig.driver.click("Stage/Force nothing");
    rig.settle();
    CHECK(answers(rig).requirements != nullptr);
    CHECK_FALSE(showsText(rig, "There is no plan"));
}

TEST_CASE("a scene without light says so, and has no plan to follow") {
    AppState state = advised();
    SceneDescription scene = state.scene->description;
    for (Shape& shape : scene.shapes) shape.emission = Rgb(0.0);
    apply(state, EditScene{scene, {}, false});
    Rig rig(std::move(state));
    CHECK(showsText(rig, "There is no light in this scene"));
    CHECK_FALSE(plannedMaker(rig.state()).has_value());
    CHECK_FALSE(rig.driver.get("Stage/Do it so").enabled);
    CHECK(lightIsComplete(rig.state()));
    CHECK(requirementsWords(rig.state()).find("Lamps: not needed") != std::string::npos);
}

TEST_CASE("what is forced is in the shared text, in the words and in the table") {
    AppState state = advised();
    InstrumentSettings settings = state.instruments;
    settings.tolerance = 0.02;
    force(settings, RequirementId::roulette, 0);
    force(settings, RequirementId::bounces, 2);
    force(settings, RequirementId::bounces, 1);
    CHECK(settings.forced.size() == 2);
    apply(state, SetInstruments{settings});
    Rig rig(std::move(state));
    const AppState copy = openShared(courseLessons(), shareText(rig.state()));
    CHECK(copy.instruments == rig.state().instruments);
    CHECK(copy.shows(View::requirements));
    const std::string words = stateText(rig.state());
    for (const char* part : {"Bounces: forced: 1", "Russian roulette: forced: off", "The tolerance is 2 %"})
        CHECK_MESSAGE(words.find(part) != std::string::npos, part);
    const auto rows = readCsv(requirementsTable(rig.state()));
    std::size_t listed = 0, forced = 0;
    for (const RequirementInfo& info : kRequirements)
        listed += std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return row[0] == info.name; });
    for (const auto& row : rows) {
        CHECK(row.size() == rows[0].size());
        if (row[0] == "bounces" && row[4] == "1") ++forced;
    }
    CHECK(listed == kRequirements.size());
    CHECK(forced == 2);  // one bounce fewer, and more
    CHECK(rows.back()[0] == "everything");
}
