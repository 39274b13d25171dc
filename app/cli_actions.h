// What does the command line ask of the window and of the headless host? Plain requests, checked but for what
// the lesson files themselves say.
//
// The actions return an exit code; they throw InputError for bad input and any other exception for a failure.
// Whether a window could be opened is hasDisplay() in window_host.h.
#pragma once

#include <filesystem>
#include <optional>

#include "app/class_rules.h"
#include "lessons/lesson_list.h"

namespace halfdisk {

inline constexpr int kExitSuccess = 0;
inline constexpr int kExitFailure = 1;
inline constexpr int kExitBadInput = 2;
inline constexpr int kExitStopped = 130;  ///< by Ctrl-C or SIGTERM; what was done by then is written

/// In pixels. What a picture may be as well as what it is by default.
struct PictureSize {
    int width = 1280, height = 800;
    bool operator==(const PictureSize&) const = default;
};
inline constexpr int kLeastPictureSize = 320, kMostPictureSize = 7680;
inline constexpr double kLeastPictureScale = 0.5, kMostPictureScale = 4.0;

/// What is to be seen first.
struct OpeningRequest {
    std::filesystem::path lessonsFolder;
    std::optional<LessonRef> lesson;             ///< none: the first lesson, or the scene alone
    std::optional<std::filesystem::path> scene;  ///< shown in place of the lesson's own
    std::optional<std::string> shared;           ///< a text of share_text.h, in place of lesson and scene
    std::string language{};                      ///< code; empty: English
};

struct WindowRequest {
    OpeningRequest opening;
    ClassRules rules{};
};

struct ScreenshotRequest {
    OpeningRequest opening;
    std::filesystem::path output;  ///< a PNG file
    PictureSize size;
    double scale = 1.0;  ///< of the user interface
};

struct ExportRequest {
    OpeningRequest opening;
    std::filesystem::path outputFolder;  ///< made if it is not there
    PictureSize size;
    double scale = 1.0;  ///< of the user interface
};

struct TourRequest {
    std::filesystem::path lessonsFolder;
    std::filesystem::path outputFolder;  ///< made if it is not there
    std::string language{};
};

int runWindow(const WindowRequest& request);
int runScreenshot(const ScreenshotRequest& request);

/// What is seen, as files: see export_files.h. Prints their names.
int runExport(const ExportRequest& request);

/// Every step of every lesson to <slug>-<step>.png.
int runTour(const TourRequest& request);

}  // namespace halfdisk
