// Are the eye's strip and the field right, always the same, and where the reader looks for them?
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "app/light_job.h"
#include "lessons/scene_file.h"
#include "rig.h"

using namespace halfdisk;

namespace {

constexpr double kSky = 0.5;  // W/(m rad)

/// A floor under an even sky, and an eye that looks straight up.
std::shared_ptr<const PreparedScene> openFloor() {
    return std::make_shared<const PreparedScene>(parseScene(R"(title = "Open floor"
environment = { radiance = 0.5 }
[material.white]
type = "diffuse"
albedo = 0.5
[[segment]]
name = "ground"
a = [0.0, 0.0]
b = [3.0, 0.0]
material = "white"
[eye]
position = [1.5, 0.05]
direction = [0.0, 1.0]
fov = 90.0
)",
                                                            "open_floor.toml"));
}

LightQuestion question(std::uint64_t id, const std::shared_ptr<const PreparedScene>& scene, double t = 0.25) {
    LightQuestion asked;
    asked.id = id;
    asked.scene = scene;
    asked.at = {0, t};
    asked.settings.samples = 4;
    asked.settings.maxDepth = 0;
    asked.pictures.set(View::eye, true);
    asked.pictures.set(View::field, true);
    return asked;
}

std::shared_ptr<const LightAnswer> answerTo(LightJob& job, const LightQuestion& asked) {
    job.ask(asked);
    job.waitUntilIdle();
    return job.latest();
}

/// Of light that no wall scattered: the sky, but where the floor (0,0) - (3,0) is.
double exactFluence(Vec2 p) {
    const double floorAngle = std::atan2(3.0 - p.x, std::abs(p.y)) + std::atan2(p.x, std::abs(p.y));
    return kSky * (2.0 * kPi - floorAngle);
}

double exactMean(const Field& field, std::uint32_t pixel) {
    const Vec2 cell = (field.max - field.min) / Vec2(field.width, field.height);
    const Vec2 corner{field.min.x + (pixel % field.width) * cell.x,
                      field.max.y - (pixel / field.width + 1) * cell.y};
    constexpr int kSteps = 16;
    double sum = 0.0;
    for (int i = 0; i < kSteps * kSteps; ++i)
        sum += exactFluence(corner + cell * ((Vec2(i % kSteps, i / kSteps) + 0.5) / double{kSteps}));
    return sum / (kSteps * kSteps);
}

bool showsText(const Rig& rig, std::string_view words) {
    for (const Widget& widget : rig.session.widgets.widgets)
        if (widget.kind == WidgetKind::text && widget.name.find(words) != std::string::npos) return true;
    return false;
}

/// The room with a mirror, by itself: everything is unlocked, and no picture is shown yet.
AppState mirrorRoom() {
    return openScene(courseLessons(), courseLessons() / "scenes/mirror_room.toml");
}

}  // namespace

TEST_CASE("the field of an open floor is the part of the sky that each place sees") {
    LightJob job;
    const auto answer = answerTo(job, question(1, openFloor()));
    REQUIRE(answer->pictures.field);
    const LightPicture& picture = *answer->pictures.field;
    CHECK(picture.complete);
    CHECK(picture.film.counts.nonFinite == 0);
    const Field& field = std::get<Field>(picture.sensor);
    REQUIRE(picture.colors.size() == std::size_t{field.width} * field.height);
    // The top row, then the lowest one, which lies below the floor.
    for (const std::uint32_t row : {0u, field.height - 1})
        for (std::uint32_t column = 3; column < field.width; column += 10) {
            const std::uint32_t pixel = row * field.width + column;
            const Statistics& value = picture.film.pixels[pixel];
            CAPTURE(row);
            CAPTURE(column);
            CHECK(std::abs(value.mean.x - exactMean(field, pixel)) < 5.0 * value.standardError().x);
        }
}

TEST_CASE("an eye under an even sky sees it evenly") {
    LightJob job;
    const auto answer = answerTo(job, question(1, openFloor()));
    REQUIRE(answer->pictures.eye);
    for (const Statistics& pixel : answer->pictures.eye->film.pixels)
        CHECK(pixel.mean.x == doctest::Approx(kSky).epsilon(1e-12));
    CHECK(answer->pictures.eye->white == doctest::Approx(kSky).epsilon(1e-12));
    for (const std::uint32_t color : answer->pictures.eye->colors) CHECK(color == 0xffffffffu);
}

TEST_CASE("the same question gives the same pictures to the bit, also after one that was given up") {
    const auto scene = openFloor();
    LightJob first, second;
    const auto a = answerTo(first, question(1, scene));
    LightQuestion other = question(1, scene);
    other.settings.seed = 77;
    second.ask(other);
    second.ask(question(2, scene, 0.75));
    const auto b = answerTo(second, question(3, scene));
    for (const auto& [one, two] :
         {std::pair{a->pictures.eye, b->pictures.eye}, std::pair{a->pictures.field, b->pictures.field}}) {
        REQUIRE((one && two));
        CHECK(one->film.passes == two->film.passes);
        CHECK(one->colors == two->colors);
        for (std::size_t i = 0; i < one->film.pixels.size(); ++i)
            CHECK(one->film.pixels[i].mean == two->film.pixels[i].mean);
    }
}

TEST_CASE("pictures are kept while P moves, and made anew for another seed or depth") {
    const auto scene = openFloor();
    LightJob job;
    const auto before = answerTo(job, question(1, scene));
    const auto moved = answerTo(job, question(2, scene, 0.6));
    CHECK(moved->pictures.field == before->pictures.field);
    CHECK(moved->pictures.eye == before->pictures.eye);
    LightQuestion asked = question(3, scene);
    asked.settings.seed = 5;
    const auto reseeded = answerTo(job, asked);
    CHECK(reseeded->pictures.field->film.pixels[0].mean != before->pictures.field->film.pixels[0].mean);
    asked.id = 4;
    asked.settings.maxDepth = 1;
    const auto deeper = answerTo(job, asked);
    CHECK(deeper->pictures.field != reseeded->pictures.field);
    CHECK(deeper->complete);
}

TEST_CASE("below the glass disk castRay and the eye find exactly nothing, and the field finds the caustic") {
    Rig rig(openLesson(courseLessons(), LessonRef{"caustic", 3}));
    const LightAnswer& answer = *rig.state().answer;
    CHECK(answer.estimate.total() == Rgb(0.0));
    REQUIRE((answer.pictures.eye && answer.pictures.field));
    const auto cellAt = [&](Vec2 p) {
        const Field& field = std::get<Field>(answer.pictures.field->sensor);
        const Vec2 place = (p - field.min) / (field.max - field.min) * Vec2(field.width, field.height);
        const auto row = field.height - 1 - static_cast<std::uint32_t>(place.y);
        return answer.pictures.field->film.pixels[row * field.width + static_cast<std::uint32_t>(place.x)]
            .mean.x;
    };
    constexpr double kSun = 1.0;  // W/m, of the scene
    CHECK(cellAt({0.0, 0.1}) > 2.0 * kSun);
    CHECK(cellAt({0.8, 0.1}) < 0.5 * kSun);
    // What the eye sees of the floor, in the disk's shadow (its radius is 1) and far to the side of it.
    const EyeStrip& strip = std::get<EyeStrip>(answer.pictures.eye->sensor);
    const auto radianceFrom = [&](Vec2 p) {
        const Receiver receiver = *fixedReceiver(answer.pictures.eye->sensor, rig.state().scene->index);
        const Response response = responseTo(receiver, glm::normalize(p - strip.eye.position));
        REQUIRE(response.weight > 0.0);
        return answer.pictures.eye->film.pixels[response.pixel].mean.x;
    };
    CHECK(radianceFrom({-0.7, 0.0}) == 0.0);
    CHECK(radianceFrom({-2.0, 0.0}) == doctest::Approx(0.5 * kSun / 2.0).epsilon(1e-9));
}

TEST_CASE("without the wish for them there are no pictures") {
    LightJob job;
    LightQuestion asked = question(1, openFloor());
    asked.pictures = {};
    const auto answer = answerTo(job, asked);
    CHECK(answer->pictures.eye == nullptr);
    CHECK(answer->pictures.field == nullptr);
    CHECK(answer->complete);
}

TEST_CASE("a scene without light has a black field, and one without an eye no strip") {
    const auto dark = std::make_shared<const PreparedScene>(parseScene(
        "title = \"Dark\"\n[[segment]]\nname = \"wall\"\na = [0.0, 0.0]\nb = [1.0, 1.0]\n", "dark.toml"));
    LightJob job;
    const auto answer = answerTo(job, question(1, dark));
    CHECK(answer->pictures.eye == nullptr);
    REQUIRE(answer->pictures.field);
    CHECK(answer->complete);
    for (const Statistics& cell : answer->pictures.field->film.pixels) CHECK(cell.mean == Rgb(0.0));
}

TEST_CASE("the end of the program does not wait for a picture") {
    auto job = std::make_unique<LightJob>();
    job->ask(question(1, openFloor()));
    while (!job->latest() || !job->latest()->pictures.eye) std::this_thread::yield();
    const auto start = std::chrono::steady_clock::now();
    job.reset();
    CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < 1.0);
}

TEST_CASE("the switches turn the pictures on, and off again") {
    Rig rig(mirrorRoom());
    CHECK(rig.state().answer->pictures.field == nullptr);
    const float before = rig.canvas().height();
    rig.driver.click("Controls/Eye");
    rig.driver.click("Controls/Field");
    rig.settle();
    REQUIRE((rig.state().answer->pictures.eye && rig.state().answer->pictures.field));
    CHECK(showsText(rig, "fluence 0"));
    CHECK(showsText(rig, "What the eye sees"));
    const Rect strip = rig.driver.get("Stage/eye strip").rect;
    CHECK(rig.canvas().max.y <= strip.top);
    CHECK(rig.canvas().height() < before);
    rig.driver.click("Controls/Eye");
    rig.driver.click("Controls/Field");
    rig.driver.frames(2);
    CHECK(rig.canvas().height() == before);
    CHECK_FALSE(showsText(rig, "fluence 0"));
}

TEST_CASE("a pixel of the strip under the pointer is the one that lights up, and only then") {
    AppState state = mirrorRoom();
    apply(state, SetView{View::eye, true});
    Rig rig(std::move(state));
    const Rect strip = rig.driver.get("Stage/eye strip").rect;
    const auto pixels = static_cast<float>(rig.state().answer->pictures.eye->colors.size());
    for (const float pixel : {0.0f, 17.0f, 128.0f, pixels - 1.0f}) {
        rig.driver.moveTo(strip.left + (pixel + 0.5f) / pixels * strip.width(), strip.bottom - 10);
        rig.driver.frames(2);
        CHECK(rig.state().eyePixel == static_cast<std::uint32_t>(pixel));
    }
    rig.driver.moveTo(strip.left + 10, strip.top - 100);
    rig.driver.frames(2);
    CHECK_FALSE(rig.state().eyePixel.has_value());
}

TEST_CASE("a scene without an eye says so") {
    Rig rig("controls:1");
    rig.apply(SetView{View::eye, true});
    rig.settle();
    CHECK(showsText(rig, "this scene has no eye"));
}

TEST_CASE("switching a picture on keeps the place in the recorded run") {
    Rig rig("controls:8");
    rig.apply(SetEvent{7});
    rig.apply(SetView{View::field, true});
    rig.settle();
    CHECK(rig.state().playback.event == 7);
    CHECK(rig.state().playback.stepping);
    CHECK(rig.state().answer->pictures.field != nullptr);
}
