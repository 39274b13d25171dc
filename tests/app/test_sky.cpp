// Can the light from where no wall is be changed by hand?
#include <doctest/doctest.h>

#include <fstream>

#include "app/edit_commands.h"
#include "app/png_image.h"
#include "lessons/scene_file.h"
#include "lessons/sky_edit.h"
#include "rig.h"

using namespace halfdisk;

namespace {

struct Bench {
    LessonsCopy folder;
    Rig rig;

    Bench() : rig(openScene(folder.folder, folder.folder / "scenes/field.toml")) {
        rig.driver.click("Stage/Edit");
        rig.driver.frames(2);
    }
    const SceneDescription& scene() const { return rig.state().scene->description; }
    const Sky& sky() const { return scene().environment; }
    void choose(const char* kind) {
        rig.driver.click("Controls/kind");
        rig.driver.frames(2);
        rig.driver.click(std::string("Controls/kind/") + kind);
        rig.driver.frames(2);
    }
};

}  // namespace

TEST_CASE("the kind of a sky is told, and another one keeps what it can") {
    Sky sky;
    CHECK(kindOf(sky) == SkyKind::none);
    setKind(sky, SkyKind::even);
    CHECK(sky.light.radiance == Rgb(1.0));
    sky.light.radiance = Rgb(2.0);
    setKind(sky, SkyKind::strip);
    CHECK(kindOf(sky) == SkyKind::strip);
    CHECK(sky.light.strip == std::vector<Rgb>(4, Rgb(1.0)));
    CHECK(sky.light.radiance == Rgb(2.0));
    sky.image = "sky.png";
    CHECK(kindOf(sky) == SkyKind::image);
    setKind(sky, SkyKind::strip);
    CHECK(sky.image.empty());
    CHECK(sky.light.strip.size() == 4);
    const Sky before = sky;
    setKind(sky, SkyKind::image);
    CHECK(sky == before);
    setKind(sky, SkyKind::none);
    CHECK(kindOf(sky) == SkyKind::none);
    CHECK(sky.light.strip.empty());
}

TEST_CASE("while nothing is selected the sky is seen and changed, and its light is computed anew") {
    Bench bench;
    CHECK(kindOf(bench.sky()) == SkyKind::even);
    bench.rig.driver.typeNumber("Controls/radiance.0", "3");
    CHECK(bench.sky().light.radiance.x == 3.0);
    bench.rig.settle();
    CHECK(bench.rig.state().answer->exact->x == doctest::Approx(6.0));  // twice the radiance
    bench.choose("strip");
    CHECK(bench.sky().light.strip.size() == 4);
    bench.rig.driver.typeNumber("Controls/90\u00b0.0", "0.25");
    CHECK(bench.sky().light.strip[1].x == 0.25);
    bench.rig.driver.typeNumber("Controls/angles", "8");
    CHECK(bench.sky().light.strip.size() == 8);
    CHECK(faultOf(bench.scene()).empty());
    const std::size_t steps = bench.rig.state().editing.history.past.size();
    bench.rig.driver.dragBy("Controls/radiance.0", 40, 0);
    CHECK(bench.rig.state().editing.history.past.size() == steps + 1);
    bench.choose("dark");
    CHECK(bench.sky().light.strip.empty());
    bench.rig.apply(SelectThings{Thing{ThingKind::shape, 0}});
    bench.rig.driver.frames(2);
    CHECK_FALSE(bench.rig.session.widgets.find("Controls/radiance"));
    for (int i = 0; i < 20; ++i) bench.rig.apply(Undo{});
    CHECK(bench.scene() == loadScene(bench.folder.folder / "scenes/field.toml"));
}

TEST_CASE("a picture beside the scene becomes the sky; what is none is told and changes nothing") {
    Bench bench;
    Image image;
    image.width = 3;
    image.height = 1;
    image.rgba = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255};
    writePng(bench.folder.folder / "scenes/far.png", image);
    bench.rig.driver.replaceText("Controls/image", "far.png");
    bench.rig.driver.frames(2);
    CHECK(bench.sky().image == "far.png");
    CHECK(bench.sky().light.strip == std::vector<Rgb>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    saveScene(bench.scene(), bench.folder.folder / "scenes/mine.toml");
    CHECK(loadScene(bench.folder.folder / "scenes/mine.toml") == bench.scene());
    const SceneDescription before = bench.scene();
    for (const char* name : {"missing.png", "field.toml", "..", "/dev/null"}) {
        CAPTURE(name);
        bench.rig.driver.replaceText("Controls/image", name);
        bench.rig.driver.frames(2);
        CHECK(bench.scene() == before);
        CHECK_FALSE(bench.rig.state().editing.message.empty());
    }
    bench.rig.apply(ChooseSkyImage{""});
    CHECK(bench.sky().image.empty());
    CHECK(bench.sky().light.strip.empty());
    CHECK(faultOf(bench.scene()).empty());
}

TEST_CASE("a strip of many angles is shown in part, and keeps the rest") {
    Bench bench;
    EditScene edit{bench.scene(), {}, false};
    edit.scene.environment.light.strip.assign(5'000, Rgb(0.5));
    bench.rig.apply(edit);
    bench.rig.driver.frames(2);
    bench.rig.driver.typeNumber("Controls/0\u00b0.0", "0.75");
    CHECK(bench.sky().light.strip.size() == 5'000);
    CHECK(bench.sky().light.strip[0].x == 0.75);
    CHECK(bench.sky().light.strip[4'999].x == 0.5);
}
