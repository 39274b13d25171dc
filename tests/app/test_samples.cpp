// Does the list of samples tell what the run found, and do the field's false colours keep the order of
// things?
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>

#include "app/false_color.h"
#include "app/theme.h"
#include "rig.h"

using namespace halfdisk;

namespace {

Rgb sumOf(const std::vector<SampleRow>& rows) {
    Rgb sum{0.0};
    for (const SampleRow& row : rows) sum += row.adds;
    return sum;
}

}  // namespace

TEST_CASE("what the rows add is the estimate, of every run") {
    Rig rig("controls:8");
    rig.apply(SetView{View::samples, true});
    for (const Named<Run>& run : kRuns) {
        CAPTURE(run.name);
        rig.apply(SetRun{run.value});
        rig.settle();
        const LightAnswer& answer = *rig.state().answer;
        REQUIRE(answer.rows);
        REQUIRE(answer.rows->size() >= 4);
        const Rgb expected = run.value == Run::castRay ? answer.estimate.total() : answer.pathRun->estimate;
        REQUIRE(gray(expected) > 0.0);
        CHECK(glm::length(sumOf(*answer.rows) - expected) < 1e-9 * glm::length(expected));
        // One row less would be found out.
        std::vector<SampleRow> fewer = *answer.rows;
        std::erase_if(fewer, [](const SampleRow& row) { return gray(row.adds) > 0.0; });
        CHECK(gray(sumOf(fewer)) < 0.5 * gray(expected));
    }
}

TEST_CASE("a click on a row goes to its step, and the row under the pointer is shown on the canvas") {
    Rig rig("controls:8");
    rig.apply(SetView{View::code, false});
    rig.apply(SetView{View::samples, true});
    rig.driver.frames(3);
    const SampleRow row = rig.state().answer->rows->at(1);
    const std::string name = fmt::format("Stage/sample at {}", row.event);
    rig.driver.moveTo(name);
    rig.driver.frames(2);
    CHECK(rig.state().shownSample == row.event);
    rig.driver.click(name);
    CHECK(rig.state().playback.event == row.event);
    CHECK(rig.state().playback.stepping);
    rig.driver.moveTo("Stage/P");
    rig.driver.frames(2);
    CHECK_FALSE(rig.state().shownSample.has_value());
}

TEST_CASE("a click on a bar of the histogram leaves the samples in it, and all come back") {
    Rig rig("controls:8");
    Settings settings = rig.state().settings;
    settings.samples = 64;
    rig.apply(UnlockAll{true});
    rig.apply(SetSettings{settings});
    rig.apply(SetView{View::code, false});
    rig.apply(SetView{View::samples, true});
    rig.apply(SetView{View::histogram, true});
    rig.settle();
    const auto rowsSeen = [&] {
        return std::count_if(rig.session.widgets.widgets.begin(), rig.session.widgets.widgets.end(),
                             [](const Widget& w) { return w.name.starts_with("Stage/sample at"); });
    };
    REQUIRE(rowsSeen() > 0);
    rig.apply(FilterSamples{std::pair(1e9, 2e9)});
    rig.driver.frames(2);
    CHECK(rowsSeen() == 0);
    rig.driver.click("Stage/Show all");
    rig.driver.frames(2);
    CHECK(rowsSeen() > 0);
    rig.scrollTo("Controls/histogram", "Controls");
    const Rect plot = rig.session.widgets.find("Controls/histogram")->target;
    rig.driver.clickAt(plot.left + 0.6f * plot.width(), plot.top + 0.5f * plot.height());
    CHECK(rig.state().sampleRange.has_value());
    CHECK(rig.state().sampleRange->first < rig.state().sampleRange->second);
}

TEST_CASE("false colours grow lighter all along their scale, for every eye") {
    double before = -1.0;
    const ImU32 black = IM_COL32(0, 0, 0, 255);
    for (int i = 0; i <= 100; ++i) {
        const double light = contrast(falseColor(i / 100.0), black);
        CHECK(light > before);
        before = light;
    }
    CHECK(before > 10.0);
    CHECK(falseColor(-1.0) == falseColor(0.0));
    CHECK(falseColor(2.0) == falseColor(1.0));
    CHECK(decadeColor(1.0) == falseColor(1.0));
    CHECK(decadeColor(0.01) == falseColor(0.5));
    CHECK(decadeColor(0.0) == falseColor(0.0));
    CHECK(decadeColor(-1.0) == falseColor(0.0));
}

TEST_CASE("the field is shown in each of its scales, each in other colours") {
    Rig rig("field:1");
    rig.apply(SetView{View::field, true});
    rig.settle();
    const auto& picture = rig.state().answer->pictures.field;
    REQUIRE(picture);
    REQUIRE_FALSE(picture->colors.empty());
    CHECK(picture->logColors.size() == picture->colors.size());
    CHECK(picture->noiseColors.size() == picture->colors.size());
    CHECK(picture->logColors != picture->colors);
    CHECK(picture->noiseColors != picture->logColors);
    for (const FieldScale scale : {FieldScale::logarithm, FieldScale::noise, FieldScale::light}) {
        rig.driver.click("Controls/colours");
        rig.driver.click(fmt::format("Controls/colours/{}", nameOf(kFieldScales, scale)));
        rig.driver.frames(2);
        CHECK(rig.state().scale == scale);
    }
}
