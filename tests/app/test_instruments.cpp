// Do the instruments measure what they are asked, and say it? The dial of extremes; trade and requirements
// have files of their own.
#include <doctest/doctest.h>

#include "app/instrument_words.h"
#include "app/share_text.h"
#include "app/state_text.h"
#include "rig.h"

using namespace halfdisk;

namespace {

bool showsText(const Rig& rig, std::string_view words) {
    for (const Widget& widget : rig.session.widgets.widgets)
        if (widget.kind == WidgetKind::text && widget.name.find(words) != std::string::npos) return true;
    return false;
}

const DialAnswer& dialOf(const Rig& rig) {
    return *rig.state().answer->instruments.dial;
}

/// A room with the dial, in float with a fixed epsilon of 1e-4.
struct DialRig : Rig {
    DialRig() : Rig("controls:1") {
        apply(UnlockAll{true});
        apply(OpenScene{courseLessons() / "scenes/white_room.toml"});
        InstrumentSettings settings;
        settings.dial.precision = Precision::single;
        settings.dial.policy = EpsilonPolicy::fixed;
        apply(SetInstruments{settings});
        apply(SetView{View::extremes, true});
        settle();
    }
    void turn(double scale, EpsilonPolicy policy = EpsilonPolicy::fixed) {
        InstrumentSettings settings = state().instruments;
        settings.dial.scale = scale;
        settings.dial.policy = policy;
        apply(SetInstruments{settings});
        settle();
    }
};

}  // namespace

TEST_CASE("the dial counts what goes wrong in the chosen tracer, and nothing in the program itself") {
    DialRig rig;
    for (const double scale : {1e-3, 1.0, 1e3}) {
        rig.turn(scale);
        REQUIRE(rig.state().answer->instruments.dial);
        const DialAnswer& answer = dialOf(rig);
        CHECK(answer.setting.scale == scale);
        // The same counts as asked directly: nothing is kept from another setting.
        const ExtremeCounts direct = measureDial(answer.setting, rig.state().scene->scene);
        CHECK(answer.chosen.leaks == direct.leaks);
        CHECK(answer.chosen.selfHits == direct.selfHits);
        CHECK(answer.chosen.faults() > 0);
        CHECK(answer.product.faults() == 0);
        CHECK(showsText(rig, "go wrong"));
    }
    const ExtremeCounts fixed = dialOf(rig).chosen;
    rig.turn(1e3, EpsilonPolicy::none);
    CHECK(dialOf(rig).chosen.selfHits >= fixed.selfHits);
}

TEST_CASE(
    "the dial is turned by hand: a typed scale, a chosen epsilon; what is wished for asks no new light") {
    DialRig rig;
    rig.driver.typeNumber("Stage/scale", "1000");
    CHECK(rig.state().instruments.dial.scale == 1000.0);
    rig.driver.typeNumber("Stage/scale", "1e9");
    CHECK(rig.state().instruments.dial.scale == kMostScale);
    rig.driver.click("Stage/epsilon");
    rig.driver.frames(2);
    rig.driver.click("Stage/epsilon/relative");
    rig.settle();
    CHECK(rig.state().instruments.dial.policy == EpsilonPolicy::relative);
    const std::uint64_t before = rig.state().questionId;
    InstrumentSettings wished = rig.state().instruments;
    wished.wishedError = 0.02;
    rig.apply(SetInstruments{wished});
    CHECK(rig.state().questionId == before);
}

TEST_CASE("the dial is part of what is shared, told in words and in a table") {
    DialRig rig;
    rig.turn(1e-3);
    const AppState again = openShared(courseLessons(), shareText(rig.state()));
    CHECK(again.instruments == rig.state().instruments);
    CHECK(again.shows(View::extremes));
    const std::string words = stateText(rig.state());
    CHECK(words.find("leak") != std::string::npos);
    const std::string table = extremesTable(rig.state());
    CHECK(std::count(table.begin(), table.end(), '\n') == 3);
    CHECK(table.find("\nhalfdisk,4000,0,0,0,") != std::string::npos);
}
