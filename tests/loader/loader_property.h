// What holds for every text whatsoever that is taken for a scene or a lesson?
#pragma once

#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

#include "lessons/lesson_file.h"
#include "lessons/scene_file.h"
#include "lessons/sky_image.h"

/// Ends the process with a message: the sign of a fault that a fuzzer understands.
inline void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "violated: %s\n", what);
    ::abort();
}

/// Every wall has a front and, in closed shapes, its neighbours' very vertices are no business of this check.
inline void checkWalls(const halfdisk::Scene& scene) {
    require(scene.segments.size() == scene.segmentNames.size(), "one name for each wall");
    for (const halfdisk::Segment& s : scene.segments) {
        require(s.material < scene.materials.size(), "each wall has a material");
        const halfdisk::Vec2 front = halfdisk::frontNormal(s);
        require(halfdisk::isFinite(front), "each wall has a front");
        if (!halfdisk::isSmooth(s)) continue;
        for (const halfdisk::Vec2 normal : {s.normalA, s.normalB, s.normalA + s.normalB})
            require(glm::dot(normal, front) > 0.0, "normals of smooth walls are on the front side");
    }
    std::vector<std::string> names = scene.segmentNames;
    std::sort(names.begin(), names.end());
    require(std::adjacent_find(names.begin(), names.end()) == names.end(), "no two walls have one name");
}

/// Stands for the file system: a picture has as many columns as its name has bytes, "none.png" is missing.
inline std::vector<halfdisk::Rgb> fakeSky(const std::string& image) {
    if (image == "none.png") throw halfdisk::InputError(image, "there is no such file");
    return std::vector<halfdisk::Rgb>(image.size(), halfdisk::Rgb(0.25, 0.5, 1.0));
}

/// Only InputError escapes; an accepted scene is written and read again as equal, and its walls are sound.
/// Returns whether it was accepted.
inline bool checkSceneText(std::string_view text) {
    halfdisk::SceneDescription scene;
    try {
        scene = halfdisk::parseScene(text, "fuzz.toml", fakeSky);
    } catch (const halfdisk::InputError& error) {
        require(error.line >= 1 && error.column >= 1, "an error of a text has a place");
        require(!error.text.empty(), "an error says something");
        return false;
    }
    const halfdisk::Scene expanded = halfdisk::expandScene(scene);
    checkWalls(expanded);
    require(expanded.environment.strip.size() <= halfdisk::kMostStripEntries, "a strip has its limit");
    if (expanded.eye)
        require(std::abs(glm::length(expanded.eye->direction) - 1.0) < 1e-12 && expanded.eye->fov > 0.0 &&
                    expanded.eye->fov < halfdisk::kPi,
                "an eye looks somewhere");
    const std::string written = halfdisk::writeScene(scene);
    const halfdisk::SceneDescription again = halfdisk::parseScene(written, "written.toml", fakeSky);
    require(again == scene, "what is written reads back equal");
    require(halfdisk::writeScene(again) == written, "what is read back is written with equal bytes");
    return true;
}

/// Only InputError escapes; an accepted lesson has steps whose points are on its walls. Returns whether it
/// was accepted.
inline bool checkLessonText(std::string_view text) {
    const auto room = [](const std::filesystem::path&) {
        return halfdisk::parseScene(
            "[[box]]\nname = \"room\"\nmin = [0, 0]\nmax = [1, 1]\n"
            "[[segment]]\nname = \"floor\"\na = [0, 0]\nb = [1, 0]\n",
            "room.toml");
    };
    halfdisk::Lesson lesson;
    try {
        lesson = halfdisk::parseLesson(text, "01-fuzz.toml", room);
    } catch (const halfdisk::InputError& error) {
        require(error.line >= 1 && error.column >= 1, "an error of a text has a place");
        require(!error.text.empty(), "an error says something");
        return false;
    }
    require(!lesson.steps.empty(), "a lesson has a step");
    for (const halfdisk::Step& step : lesson.steps) {
        require(step.values.at.segment < 5 && step.values.at.t >= 0.0 && step.values.at.t <= 1.0,
                "P is on a wall");
        require(step.values.settings.samples >= 1, "there is a sample");
        for (const halfdisk::Paragraph& paragraph : step.prose)
            for (const halfdisk::Span& span : paragraph.spans)
                require(span.style != halfdisk::SpanStyle::term || span.term < lesson.terms.size(),
                        "a term is known");
    }
    return true;
}
