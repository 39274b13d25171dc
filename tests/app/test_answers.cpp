// Can a question be answered by doing, and does a term show what it speaks of?
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "app/goal_check.h"
#include "app/language.h"
#include "rig.h"

using namespace halfdisk;

namespace {

const Goal& goalOf(const Rig& rig) {
    return *rig.state().currentStep()->goal;
}

/// Whether the panel says that the goal is reached.
bool saysReached(const Rig& rig) {
    return rig.session.widgets.find("Lesson/Reached!") != nullptr;
}

/// The step of the course whose goal looks at this.
LessonRef stepWith(GoalQuantity quantity) {
    for (const LessonEntry& entry : listLessons(courseLessons())) {
        const AppState opened = openLesson(courseLessons(), LessonRef{entry.slug, 1});
        for (std::size_t i = 0; i < opened.lesson->steps.size(); ++i)
            if (opened.lesson->steps[i].goal && opened.lesson->steps[i].goal->quantity == quantity)
                return {entry.slug, static_cast<int>(i) + 1};
    }
    throw std::runtime_error("no step asks for this");
}

/// Draws the exact curve, times `factor`, bin by bin as a hand would.
void drawExactly(Rig& rig, double factor) {
    const std::vector<IntegrandPoint> exact = rig.state().answer->integrand;
    double before = 0.0, height = 0.0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const double now = factor * gray(exact[i].radiance);
        rig.apply(DrawCurve{i == 0 ? exact[i].theta : before, exact[i].theta, i == 0 ? now : height, now});
        before = exact[i].theta;
        height = now;
    }
    rig.apply(EndStroke{});
}

}  // namespace

TEST_CASE("a question for a line is answered by a click on it, right or wrong") {
    Rig rig(openLesson(courseLessons(), stepWith(GoalQuantity::line)));
    rig.settle();
    const Goal goal = goalOf(rig);
    REQUIRE_FALSE(goal.lines.empty());
    CHECK_FALSE(valueOf(goal, rig.state()).has_value());
    CHECK_FALSE(saysReached(rig));
    for (const int line : {3, 33, goal.lines.front()}) {
        rig.scrollTo(fmt::format("Stage/line {:03}", line), "Stage/line");
        rig.driver.click(fmt::format("Stage/line {:03}", line));
        rig.settle();
        rig.driver.frames(2);
        CAPTURE(line);
        const bool right = std::count(goal.lines.begin(), goal.lines.end(), line) > 0;
        CHECK(rig.state().chosenLine == line);
        CHECK(saysReached(rig) == right);
    }
    rig.apply(ResetStep{});
    CHECK(rig.state().chosenLine == 0);
    rig.driver.frames(2);
    CHECK_FALSE(saysReached(rig));
}

TEST_CASE("a curve is hidden until it is drawn, and judged by the area between it and the exact one") {
    Rig rig(openLesson(courseLessons(), stepWith(GoalQuantity::drawn)));
    rig.settle();
    const Goal goal = goalOf(rig);
    CHECK(asksForCurve(rig.state()));
    CHECK_FALSE(isDrawn(rig.state()));
    CHECK_FALSE(valueOf(goal, rig.state()).has_value());
    // The curve's name stands in the plot only when the curve does.
    const auto curveIsSeen = [&] { return rig.session.widgets.find("Stage/L(\u03b8)") != nullptr; };
    CHECK_FALSE(curveIsSeen());

    drawExactly(rig, 1.0);
    rig.driver.frames(2);
    CHECK(isDrawn(rig.state()));
    CHECK(curveIsSeen());
    REQUIRE(valueOf(goal, rig.state()).has_value());
    const double right = *valueOf(goal, rig.state());
    // Only what varies within one of the bins is missed.
    CHECK(right > 0.9);
    CHECK(right <= 1.0);
    CHECK(saysReached(rig));

    rig.apply(ResetStep{});
    rig.settle();
    CHECK(rig.state().drawn.empty());
    CHECK_FALSE(curveIsSeen());
    drawExactly(rig, 0.5);
    // Half of everything is missing: the area between is half of it.
    CHECK(*valueOf(goal, rig.state()) == doctest::Approx(0.5).epsilon(0.1));
    drawExactly(rig, 0.0);
    CHECK(*valueOf(goal, rig.state()) == doctest::Approx(0.0));
    drawExactly(rig, 5.0);
    CHECK(*valueOf(goal, rig.state()) == 0.0);
}

TEST_CASE("the curve is drawn with the mouse, from one end of the plot to the other") {
    Rig rig(openLesson(courseLessons(), stepWith(GoalQuantity::drawn)));
    rig.settle();
    const Rect plot = rig.session.widgets.find("Stage/integrand")->rect;
    const float y = plot.top + 0.7f * plot.height();
    rig.driver.moveTo(plot.left + 0.09f * plot.width(), y);
    rig.driver.press();
    for (int i = 10; i <= 99; ++i)
        rig.driver.moveTo(plot.left + 0.01f * static_cast<float>(i) * plot.width(), y);
    CHECK_FALSE(isDrawn(rig.state()));  // the button is still down
    rig.driver.release();
    rig.driver.frames(2);
    CHECK_FALSE(rig.state().drawing);
    CHECK(isDrawn(rig.state()));
    for (const float value : rig.state().drawn) CHECK(std::isfinite(value));
}

TEST_CASE("whatever is drawn, the state stays sound") {
    Rig rig(openLesson(courseLessons(), stepWith(GoalQuantity::drawn)));
    rig.settle();
    const double bad = std::nan(""), far = 1e300;
    for (const DrawCurve& stroke : {DrawCurve{bad, bad, bad, bad}, DrawCurve{-far, far, -far, far},
                                    DrawCurve{0.0, 3.0, bad, 1.0}, DrawCurve{3.0, 0.0, 1.0, INFINITY}})
        rig.apply(stroke);
    rig.apply(EndStroke{});
    for (const float value : rig.state().drawn) CHECK(std::isfinite(value));
}

TEST_CASE("a term that is looked up lights up, and nothing is lit when the pointer leaves") {
    Rig rig(openLesson(courseLessons(), LessonRef{"seven-steps", 2}));
    rig.settle();
    const Widget* term = rig.session.widgets.find("Lesson/shadow");
    REQUIRE(term != nullptr);
    const Rect rect = term->rect;
    rig.driver.moveTo((rect.left + rect.right) / 2, (rect.top + rect.bottom) / 2);
    rig.driver.frames(2);
    CHECK(rig.state().topic == Topic::shadowRay);
    rig.driver.moveTo(rect.left, rect.bottom + 400);
    rig.driver.frames(2);
    CHECK(rig.state().topic == Topic::none);
}

TEST_CASE("topics are found by the English name, in every language") {
    CHECK(topicOf("Shadow Ray") == Topic::shadowRay);
    CHECK(topicOf("pdf") == Topic::sample);
    CHECK(topicOf("shadow") == Topic::none);
    CHECK(topicOf("") == Topic::none);
    AppState state = openLesson(courseLessons(), LessonRef{"seven-steps", 1});
    const std::vector<Term> english = state.lesson->terms;
    apply(state, SetLanguage{"de"});
    REQUIRE(state.lesson->terms.size() == english.size());
    for (std::size_t i = 0; i < english.size(); ++i) {
        CHECK(state.lesson->terms[i].topic == english[i].topic);
        CHECK(state.lesson->terms[i].meaning != english[i].meaning);
    }
    for (const TopicRow& row : kTopics)
        for (const int line : row.listing) CHECK((line >= 0 && line <= kListingLines));
}
