// Do the exported files hold what is seen: whole, well-formed, the same each time, and equal to the light's
// own numbers?
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "app/light_progress.h"
#include "app/plot_tables.h"
#include "app/png_image.h"
#include "app/state_text.h"
#include "app/tree_json.h"
#include "export_rig.h"
#include "file_reading.h"
#include "lessons/utf8.h"

using namespace halfdisk;
using Json = nlohmann::json;

namespace {

/// With everything shown that a state can show.
AppState richState() {
    AppState state = openLesson(testLessons(), LessonRef{"controls", 1});
    SceneDescription scene = state.scene->description;
    scene.eye = EyeDescription{(state.scene->bounds.min + state.scene->bounds.max) / 2.0, {1.0, -0.5}, 80.0};
    apply(state, EditScene{scene, std::nullopt, false});
    for (const View view :
         {View::halfdisk, View::rays, View::tree, View::integrand, View::error, View::histogram, View::exact,
          View::numbers, View::grid, View::eye, View::field, View::profile, View::strategies})
        apply(state, SetView{view, true});
    apply(state, SetView{View::code, false});
    Settings settings = state.settings;
    settings.samples = 8;
    settings.maxDepth = 1;
    apply(state, SetSettings{settings});
    return state;
}

/// A scene whose names need care in every kind of file.
constexpr const char* kOddName = "a<b & \"c\", 'd'>";
AppState oddState() {
    AppState state = richState();
    SceneDescription scene = state.scene->description;
    scene.shapes[0].name = kOddName;
    apply(state, EditScene{scene, std::nullopt, false});
    for (std::uint32_t i = 0; i < state.scene->scene.segments.size(); ++i)
        if (state.scene->scene.segmentNames[i].find('&') != std::string::npos) {
            apply(state, MovePoint{{i, 0.25}});
            break;
        }
    return state;
}

std::multiset<std::string> textsWithin(const Session& session, const std::string& window, const Rect& area) {
    std::multiset<std::string> texts;
    for (const Widget& widget : session.widgets.widgets)
        if (widget.kind == WidgetKind::text && widget.window == window && widget.rect.left >= area.left &&
            widget.rect.right <= area.right && widget.rect.top >= area.top &&
            widget.rect.bottom <= area.bottom)
            texts.insert(widget.name.substr(window.size() + 1));
    return texts;
}

double number(const std::string& cell) {
    return std::stod(cell);
}

/// Index of a column by the part of its header before the unit.
std::size_t column(const std::vector<std::vector<std::string>>& table, std::string_view name) {
    for (std::size_t i = 0; i < table[0].size(); ++i)
        if (table[0][i].substr(0, table[0][i].find(' ')) == name) return i;
    FAIL("no column ", std::string(name));
    return 0;
}

std::vector<std::vector<std::string>> tableOf(const std::vector<ExportFile>& files, std::string_view name) {
    const std::string* bytes = fileOf(files, name);
    REQUIRE_MESSAGE(bytes, std::string(name));
    return readCsv(*bytes);
}

std::size_t longestLine(std::string_view text) {
    std::size_t longest = 0;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        longest = std::max(longest, characterCount(line));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
    }
    return longest;
}

}  // namespace

TEST_CASE("export: every drawing is well-formed XML, and its words are those of the screen, each once") {
    for (const bool odd : {false, true}) {
        Rig rig(odd ? oddState() : richState(), 1920, 1200);
        rig.settle();
        const auto files = exported(rig);
        rig.host->frameWithoutDrawing([&] { frame(rig.session, rig.host->fonts(), rig.host->uiScale()); });
        int drawings = 0;
        for (const ExportFile& file : files) {
            if (file.name.find(".svg") == std::string::npos) continue;
            CAPTURE(file.name);
            ++drawings;
            const XmlFile xml = readXml(file.bytes);
            REQUIRE_MESSAGE(xml.fault.empty(), xml.fault);
            CHECK(xml.elements.front() == "svg");
            CHECK_FALSE(xml.title.empty());
            CHECK_FALSE(xml.description.empty());
            CHECK(std::set<std::string>(xml.ids.begin(), xml.ids.end()).size() == xml.ids.size());
            for (const std::string& used : xml.uses)
                CHECK(std::count(xml.ids.begin(), xml.ids.end(), used) == 1);
            const std::string name = file.name.substr(0, file.name.find('.'));
            const bool onStage = name == "canvas" || name == "eye" || name == "strategies";
            const std::string window = onStage ? "Stage" : "Controls";
            const Widget& widget =
                rig.driver.get(fmt::format("{}/{}", window, name == "eye" ? "eye strip" : name));
            const auto seen = textsWithin(rig.session, window, widget.rect);
            CHECK_FALSE(seen.empty());
            CHECK(std::multiset<std::string>(xml.texts.begin(), xml.texts.end()) == seen);
        }
        CHECK(drawings == 7);
        if (!odd) continue;
        CHECK(readXml(*fileOf(files, "profile.svg")).texts[0] ==
              fmt::format("Light along \"{}.0\"", kOddName));
        CHECK(fileOf(files, "state.txt")->find(kOddName) != std::string::npos);
        const Json tree = Json::parse(*fileOf(files, "tree.json"));
        CHECK(tree["point"]["wall"] == fmt::format("{}.0", kOddName));
    }
}

TEST_CASE("export: the same state gives the same bytes, another seed others") {
    Rig first(richState()), second(richState());
    AppState other = richState();
    Settings settings = other.settings;
    ++settings.seed;
    apply(other, SetSettings{settings});
    Rig third(std::move(other));
    const auto a = exported(first), b = exported(second), c = exported(third), again = exported(first);
    REQUIRE(a.size() == b.size());
    std::set<std::string> differ;
    for (std::size_t i = 0; i < a.size(); ++i) {
        CHECK(a[i].name == b[i].name);
        CHECK_MESSAGE(a[i].bytes == b[i].bytes, a[i].name);
        CHECK_MESSAGE(a[i].bytes == again[i].bytes, a[i].name);
        if (a[i].bytes != c[i].bytes) differ.insert(a[i].name);
    }
    for (const char* name : {"canvas.svg", "histogram.csv", "field.csv", "tree.json", "state.txt"})
        CHECK_MESSAGE(differ.count(name) == 1, name);
}

TEST_CASE("export: the tables hold the light's own numbers") {
    Rig rig(richState());
    const auto files = exported(rig);
    const LightAnswer& answer = *rig.state().answer;

    const auto integrand = tableOf(files, "integrand.csv");
    REQUIRE(integrand.size() == answer.integrand.size() + 1);
    for (const std::size_t i : {std::size_t{0}, answer.integrand.size() / 3, answer.integrand.size() - 1}) {
        const IntegrandPoint& point = answer.integrand[i];
        const auto& row = integrand[i + 1];
        CHECK(number(row[column(integrand, "thetaFromNormal")]) ==
              doctest::Approx(90.0 - point.theta * 180.0 / kPi));
        CHECK(number(row[column(integrand, "LG")]) == point.radiance.y);
        CHECK(number(row[column(integrand, "LcosB")]) == point.radiance.z * std::sin(point.theta));
    }

    const auto error = tableOf(files, "error.csv");
    REQUIRE(error.size() == answer.errors.size() + 1);
    for (std::size_t i = 0; i < answer.errors.size(); ++i) {
        CHECK(number(error[i + 1][0]) == answer.errors[i].samples);
        CHECK(number(error[i + 1][1]) == answer.errors[i].rms);
        CHECK(number(error[i + 1][2]) == answer.errors[i].spread);
    }

    const auto histogram = tableOf(files, "histogram.csv");
    double samples = 0.0, share = 0.0, ofRun = 0.0;
    for (std::size_t i = 1; i < histogram.size(); ++i) {
        samples += number(histogram[i][column(histogram, "samples")]);
        share += number(histogram[i][column(histogram, "share")]);
        ofRun += number(histogram[i][column(histogram, "ofThisRun")]);
        if (i > 1) CHECK(histogram[i][0] == histogram[i - 1][1]);
    }
    CHECK(samples == static_cast<double>(answer.histogramOf.size()));
    CHECK(share == doctest::Approx(100.0));
    CHECK(ofRun == static_cast<double>(answer.contributions.size()));

    for (const auto& [view, name, light] :
         {std::tuple{View::profile, "profile.csv", "E"}, std::tuple{View::eye, "eye.csv", "L"},
          std::tuple{View::field, "field.csv", "fluence"}}) {
        const auto table = tableOf(files, name);
        const PixelStatistics& pixels = answer.pictures.of(view)->film.pixels;
        REQUIRE(table.size() == pixels.size() + 1);
        for (const std::size_t i : {std::size_t{0}, pixels.size() / 2, pixels.size() - 1}) {
            CHECK(number(table[i + 1][column(table, fmt::format("{}R", light))]) == pixels[i].mean.x);
            CHECK(number(table[i + 1][column(table, fmt::format("{}B", light))]) == pixels[i].mean.z);
            CHECK(number(table[i + 1][column(table, "errorG")]) == pixels[i].standardError().y);
        }
    }
    const auto strategies = tableOf(files, "strategies.csv");
    double shares = 0.0;
    for (std::size_t i = 1; i < strategies.size(); ++i)
        if (strategies[i][column(strategies, "place")].empty())
            shares += number(strategies[i][column(strategies, "share")]);
    CHECK(shares == doctest::Approx(100.0));  // depth 1: none is too long
    for (const std::string& name : strategies[0])
        CHECK((name == "s" || name == "t" || name.find(" (") != std::string::npos));
    CHECK(strategies[0][4] == "R (W/(m rad))");
    const auto field = tableOf(files, "field.csv");
    const Field& grid = std::get<Field>(answer.pictures.field->sensor);
    CHECK(number(field[1][column(field, "x")]) > grid.min.x);
    CHECK(number(field[1][column(field, "y")]) < grid.max.y);
    CHECK(number(field[1][column(field, "y")]) > number(field.back()[column(field, "y")]));
}

TEST_CASE("export: differences from the exact profile are seen, told and written for both makers") {
    AppState state = openLesson(courseLessons(), LessonRef{"trade", 1});
    const auto& steps = state.lesson->steps;
    const auto step = std::find_if(steps.begin(), steps.end(), [](const Step& one) {
        return one.show.has(View::profile) && one.show.has(View::difference);
    });
    REQUIRE(step != steps.end());
    apply(state, GoTo{"trade", static_cast<std::size_t>(step - steps.begin())});
    Rig rig(std::move(state));
    const auto files = exported(rig);
    const auto table = tableOf(files, "difference.csv");
    const LightAnswer& answer = *rig.state().answer;
    const auto& exact = *answer.exactPictures[0].profile;
    REQUIRE(table.size() == 2 * exact.size() + 1);
    double mean = 0.0;
    for (const Rgb& bin : exact) mean += bin.y / static_cast<double>(exact.size());
    const PixelStatistics& bins = answer.pictures.profile->film.pixels;
    for (const std::size_t i : {std::size_t{0}, exact.size() / 3, exact.size() - 1})
        CHECK(number(table[i + 1][column(table, "difference")]) ==
              doctest::Approx(100.0 * (bins[i].mean.y - exact[i].y) / mean).epsilon(1e-6));
    const Rect above = rig.driver.get("Stage/profile").rect, below = rig.driver.get("Stage/difference").rect;
    CHECK(below.top >= above.bottom);
    CHECK(readXml(*fileOf(files, "difference.svg")).texts.size() > 8);
    CHECK(stateText(rig.state()).find("of the exact mean") != std::string::npos);
    rig.apply(SetView{View::difference, false});
    rig.settle();
    CHECK_FALSE(rig.session.widgets.find("Stage/difference"));
}

TEST_CASE("export: two makers stand below each other in a table, and one that refuses has no rows") {
    AppState state = richState();
    apply(state, SetMakers{{makerOf("light"), makerOf("path")}});
    Rig rig(std::move(state));
    const auto field = tableOf(exported(rig), "field.csv");
    const LightAnswer& answer = *rig.state().answer;
    std::map<std::string, std::size_t> rows;
    for (std::size_t i = 1; i < field.size(); ++i) ++rows[field[i][0]];
    CHECK(rows.size() == 2);
    CHECK(field.size() ==
          1 + answer.pictures.field->film.pixels.size() + answer.against.field->film.pixels.size());
    AppState refused = richState();
    apply(refused, SetMakers{{makerOf("bidirectional"), std::nullopt}});  // does not serve a field
    Rig other(std::move(refused));
    const auto files = exported(other);
    CHECK(tableOf(files, "field.csv").size() == 1);
    CHECK(fileOf(files, "state.txt")->find("No picture:") != std::string::npos);
}

TEST_CASE("export: the tree is the record, event by event") {
    AppState state = richState();
    apply(state, SetEvent{5});
    Rig rig(std::move(state));
    rig.apply(SetEvent{5});
    rig.settle();
    const Json tree = Json::parse(treeJson(rig.state()));
    const LightAnswer& answer = *rig.state().answer;
    const Record& record = *answer.record;
    REQUIRE(tree["events"].size() == record.events.size());
    REQUIRE(tree["calls"].size() == record.calls.size());
    CHECK(tree["settings"]["samples"] == 8);
    CHECK(tree["settings"]["depth"] == 1);
    CHECK(tree["lesson"] == "controls");
    CHECK(tree["step"] == 1);
    CHECK(tree["rays"] == answer.rays);
    CHECK(tree["truncated"] == false);
    CHECK(tree["shownEvents"] == 5);
    CHECK(tree["walls"].size() == rig.state().scene->scene.segments.size());
    CHECK(tree["estimate"]["total"][1] == answer.estimate.total().y);
    CHECK(tree["exact"][0] == answer.exact->x);
    double sum = 0.0;  // of what P's own half-disk adds
    for (std::size_t i = 0; i < record.events.size(); ++i) {
        const Json& event = tree["events"][i];
        const Event& meant = record.events[i];
        REQUIRE(event["event"] == i);
        REQUIRE(event["kind"] == nameOf(kEventKinds, meant.kind));
        REQUIRE(event["line"] == listingLine(meant.kind));
        REQUIRE(event["call"] == meant.call);
        REQUIRE(event["n"] == meant.n);
        REQUIRE(event["theta"] == meant.theta);
        REQUIRE(event["to"][0] == meant.to.x);
        REQUIRE(event["value"][2] == meant.value.z);
        REQUIRE(event["missed"] == meant.missed);
        if (meant.kind == EventKind::accumulate && meant.depth == 0) sum += meant.value.y;
        if (meant.kind == EventKind::average && meant.depth == 0)
            CHECK(event["value"][1].get<double>() == doctest::Approx(sum / 8.0));
    }
    CHECK(sum > 0.0);
    for (std::size_t i = 0; i < record.calls.size(); ++i) {
        const Json& call = tree["calls"][i];
        REQUIRE(call["call"] == i);
        if (i == 0) CHECK(call["parent"].is_null());
        if (i > 0) CHECK(call["parent"] == record.calls[i].parent);
        CHECK(tree["events"][call["firstEvent"].get<std::size_t>()]["kind"] == "enter");
        CHECK(tree["events"][call["lastEvent"].get<std::size_t>()]["kind"] == "leave");
    }
}

TEST_CASE("export: a run that is refused, and light that is not there yet, are told") {
    AppState state = richState();
    Settings settings = state.settings;
    settings.samples = 4096;
    settings.maxDepth = 8;
    apply(state, SetSettings{settings});
    Rig rig(state);
    const Json tree = Json::parse(treeJson(rig.state()));
    CHECK(tree["refused"] == true);
    CHECK(tree["events"].empty());
    CHECK(stateText(rig.state()).find("It was not begun") != std::string::npos);
    CHECK(stateText(state).find("not complete yet, 0 %") != std::string::npos);
    CHECK(Json::parse(treeJson(state))["calls"].empty());
    for (const PlotTable& plot : kPlotTables) CHECK(readCsv(plot.table(state)).size() == 1);
}

TEST_CASE("export: the words tell the step, the scene, P, the numbers and every drawing, at most 100 wide") {
    Rig rig(richState());
    const std::string words = stateText(rig.state());
    CHECK(longestLine(words) <= 100);
    const Step& step = *rig.state().currentStep();
    CHECK(words.find(step.title) != std::string::npos);
    for (const std::string& wall : rig.state().scene->scene.segmentNames)
        CHECK_MESSAGE(words.find(wall.substr(0, wall.rfind('.'))) != std::string::npos, wall);
    for (const char* heading : {"Settings", "Numbers", "The scene", "Light arriving at P", "Error against N",
                                "What single samples bring", "What the eye sees", "The field of light",
                                "The recorded run of castRay", "estimate of E: ", "exact E: ", "P is at ("})
        CHECK_MESSAGE(words.find(heading) != std::string::npos, heading);
    CHECK(words.find(fmt::format("{} steps", rig.state().eventCount())) != std::string::npos);
    CHECK(words.find("not complete") == std::string::npos);
}

TEST_CASE(
    "export: a small screen and the editor hide nothing from the files, and nothing on screen is changed") {
    for (const bool editing : {false, true}) {
        Rig rig(richState(), 480, 400);
        rig.apply(SetEditing{editing});
        rig.apply(ToggleHelp{});
        rig.session.state.banner = "something went wrong";
        rig.apply(ShowPane{Pane::controls});
        rig.apply(SetCamera{Camera{Vec2(0.5), 77.0}});
        const AppState before = rig.state();
        const auto files = exported(rig);
        for (const char* name :
             {"canvas.svg", "integrand.svg", "error.svg", "histogram.svg", "profile.svg", "eye.svg"})
            CHECK_MESSAGE(fileOf(files, name), name);
        CHECK(rig.state().helpShown);
        CHECK(rig.state().banner == before.banner);
        CHECK(rig.state().pane == before.pane);
        CHECK(rig.state().camera == before.camera);
        CHECK(rig.state().editing.on == editing);
        CHECK(rig.state().questionId == before.questionId);
    }
}

TEST_CASE("export: every lesson's first step has its canvas, and a table beside each plot") {
    for (const LessonEntry& entry : listLessons(courseLessons())) {
        CAPTURE(entry.slug);
        Rig rig(openLesson(courseLessons(), LessonRef{entry.slug, 1}));
        const auto files = exported(rig);
        CHECK(fileOf(files, "canvas.svg"));
        for (const ExportFile& file : files) {
            if (file.name.find(".svg") == std::string::npos) continue;
            const XmlFile xml = readXml(file.bytes);
            CHECK_MESSAGE(xml.fault.empty(), file.name, ": ", xml.fault);
            const std::string name = file.name.substr(0, file.name.find('.'));
            if (name != "canvas") CHECK(readCsv(*fileOf(files, name + ".csv")).size() > 1);
        }
        CHECK(longestLine(*fileOf(files, "state.txt")) <= 100);
        for (const PlotTable& plot : kPlotTables)
            CHECK((fileOf(files, fmt::format("{}.csv", plot.name)) != nullptr) ==
                  rig.state().shows(plot.view));
    }
}

TEST_CASE("export: another estimator's run is told in its own words and events") {
    for (const Named<Run>& run : kRuns) {
        if (run.value == Run::castRay) continue;
        CAPTURE(run.name);
        AppState state = richState();
        apply(state, SetRun{run.value});
        Rig rig(std::move(state));
        rig.settle();
        rig.apply(SetEvent{4});
        const PathRun& told = *rig.state().answer->pathRun;
        const Json tree = Json::parse(treeJson(rig.state()));
        CHECK(tree["run"] == run.name);
        CHECK(tree["calls"].empty());
        CHECK(tree["divisor"] == told.divisor);
        REQUIRE(tree["events"].size() == told.record.events.size());
        double sum = 0.0;
        for (const Json& event : tree["events"]) {
            sum += event["value"][0].get<double>();
            CHECK(event["file"].get<std::string>().rfind("core/", 0) == 0);
        }
        CHECK(sum / told.divisor == doctest::Approx(told.estimate.x));
        const std::string words = stateText(rig.state());
        CHECK(words.find(fmt::format("recorded run of {}", run.name)) != std::string::npos);
        CHECK(words.find("Shown up to step 4") != std::string::npos);
    }
}
