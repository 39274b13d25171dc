// Where are the golden pictures, and when does a picture match its golden one?
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "app/png_image.h"
#include "lessons/lesson_list.h"

namespace halfdisk {

inline constexpr int kGoldenWidth = 1280, kGoldenHeight = 800;
inline constexpr int kToleranceLevels = 2;
inline constexpr std::size_t kMostOutliers = 20;  ///< pixels

std::filesystem::path goldenFolder();
/// Sizes of letters: as on a desk, and for the last row.
inline constexpr std::array<float, 2> kGoldenScales{1.0f, 2.0f};

/// "gather-1"
std::string goldenName(const LessonRef& step);
/// At kGoldenScales[scale]: assets/golden/gather-1.png, assets/golden/scale2/gather-1.png.
std::filesystem::path goldenFile(const LessonRef& step, std::size_t scale = 0);

/// Every step of every lesson of the course, in its order. Throws InputError if a lesson is broken.
std::vector<LessonRef> courseSteps();

/// As the program draws it, without a display: one picture for each of kGoldenScales.
std::vector<Image> picturesOfStep(const LessonRef& step);

/// Equal sizes, and no more pixels beyond the tolerance than allowed.
bool matches(const Image& actual, const Image& golden);

}  // namespace halfdisk
