// What does the screen know about the light at P? Everything that is computed behind the frame, as plain
// data.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/instrument_answers.h"
#include "app/light_picture.h"
#include "app/prepared_scene.h"
#include "app/ray_cloud.h"
#include "app/strategy_grid.h"
#include "core/estimate.h"
#include "core/exact_field.h"
#include "core/light_way.h"
#include "core/path_run.h"
#include "core/recorder.h"
#include "lessons/lesson.h"

namespace halfdisk {

/// Where to find in a record what every frame draws: a record may have 100 000 events, a frame 8 ms.
struct RecordSummary {
    std::vector<std::uint32_t> atP;     ///< events of depth 0
    std::vector<std::uint32_t> deeper;  ///< the first arrivals below it, as many as are drawn
    std::size_t deeperCount = 0;        ///< all of them, also those that the record lacks
    double brightest = 0.0;  ///< most that a half-disk ray brings, W / (m rad), mean of the channels
};

/// What is asked: the light at a wall point, by these settings.
struct LightQuestion {
    std::uint64_t id = 0;  ///< later questions have larger ones
    std::shared_ptr<const PreparedScene> scene{};
    WallPoint at{};
    Settings settings{};
    bool wantsDamage = false;  ///< also what each defect alone does
    ViewSet pictures{};        ///< of kPictureSet: those that are wanted too
    ViewSet instruments{};     ///< of kInstrumentSet: those that are wanted too
    InstrumentSettings instrumentSettings{};
    Makers makers{};                       ///< of the pictures
    Run run = Run::castRay;                ///< that is recorded
    std::optional<std::uint32_t> pixel{};  ///< of the eye's strip, if its run is recorded and not that at P
    Side pixelOf = Side::first;            ///< whose strip it is of
    bool wantsTree = false;                ///< also a cloud of its deeper rays, if they are many
    double effort = 1.0;                   ///< share of the usual work that is done after the first run, > 0

    bool operator==(const LightQuestion&) const = default;
};

/// What one maker made; null: not begun, not wanted, or (eye) the scene has none.
struct PictureSet {
    std::shared_ptr<const LightPicture> eye, field, profile;

    std::shared_ptr<const LightPicture>& of(View view) {
        return view == View::eye ? eye : view == View::field ? field : profile;
    }
    const std::shared_ptr<const LightPicture>& of(View view) const {
        return view == View::eye ? eye : view == View::field ? field : profile;
    }
};

/// What the same pictures would be without noise, mean of every pixel (of `of`: not the field); null: not
/// wanted, or not known.
struct ExactPictures {
    std::shared_ptr<const std::vector<Rgb>> eye, profile;
    std::shared_ptr<const KnownCells> field;  ///< of some cells

    std::shared_ptr<const std::vector<Rgb>>& of(View view) { return view == View::eye ? eye : profile; }
    const std::shared_ptr<const std::vector<Rgb>>& of(View view) const {
        return view == View::eye ? eye : profile;
    }
};

/// Light that arrives along one direction of the half-disk.
struct IntegrandPoint {
    double theta;  ///< rad from the tangent
    Rgb radiance;  ///< W / (m rad)
};

/// Error of the estimate of E after N samples.
struct ErrorPoint {
    double samples;
    double rms;     ///< W / m, mean of the channels, over many runs
    double spread;  ///< one standard error of rms
};

/// One sample of the run, or one path of another estimator's.
struct SampleRow {
    std::size_t event = 0;               ///< step of the run at which its value is known
    std::uint32_t number = 0;            ///< counted from 0
    std::uint32_t segment = kNoSegment;  ///< the wall or lamp that it met; none: the sky, or many walls
    enum class Kind : std::uint8_t { halfDisk, light, path } kind = Kind::halfDisk;
    double theta = 0.0;  ///< rad from the tangent (halfDisk)
    Rgb brings{0.0};     ///< W/(m rad) (halfDisk)
    Rgb adds{0.0};       ///< to the estimate, in its unit: see unitOf
    std::string word{};  ///< (path) of the way by which most of its light came; without light of its walls
    std::uint32_t finds = 0;  ///< (path) how often it found light
};

/// What one defect alone does to E.
struct Damage {
    Defect defect;
    double relative;  ///< (E - exact E) / exact E, mean of the channels
    double error;     ///< its standard error
};

/// Grows stage by stage; each stage publishes a new copy. The frame only reads.
struct LightAnswer {
    LightQuestion asked;
    ShadedPoint point;  ///< P and N
    std::uint64_t rays = 0;
    bool tooManyRays = false;  ///< `rays` would be needed, so nothing was cast

    // stage 1: one run of N samples, every step recorded
    std::shared_ptr<const Record> record;
    RecordSummary summary;
    std::shared_ptr<const std::vector<CloudLine>> treeLines;  ///< of a cloud that is still to be made
    std::shared_ptr<const RayCloud> tree;  ///< deeper rays that are too many to be drawn as lines
    std::shared_ptr<const std::vector<SampleRow>> rows;  ///< of the run that is shown
    std::shared_ptr<const PathRun> pathRun;  ///< of another estimator than castRay, if one is asked for
    Irradiance estimate;
    std::optional<Rgb> radiance;  ///< that P's wall sends out, if it is diffuse: else it depends on the view
    std::optional<Irradiance> corrected;  ///< with defects on: the same run without them
    std::vector<Rgb> contributions;       ///< of each first-bounce sample, light samples excluded
    std::optional<Rgb> standardError;     ///< of the run, from its own samples; none for dependent samples
    std::uint64_t nonFinite = 0;

    // stage 2: what is exactly known
    std::optional<Rgb> exact;  ///< E
    std::vector<IntegrandPoint> integrand;

    // stage 3: many runs
    Statistics runs;                  ///< of whole runs of N
    std::vector<double> histogramOf;  ///< single contributions, mean of the channels, up to a few thousand
    std::vector<ErrorPoint> errors;
    std::vector<Damage> damage;
    bool pointComplete = false;  ///< all that is asked about P is done

    // stage 4: pictures, which do not depend on P (the profile only on its wall)
    PictureSet pictures, against;
    std::array<ExactPictures, 2> exactPictures;                 ///< of both makers, whose depths may differ
    std::shared_ptr<const StrategyGrid> strategies;             ///< null: not begun, or not wanted
    std::shared_ptr<const std::vector<LightWay>> ways;          ///< of View::paths
    std::shared_ptr<const RayCloud> wayCloud;                   ///< all of them
    std::vector<std::pair<std::string, std::size_t>> wayWords;  ///< how many have each word, commonest first
    std::optional<std::size_t> throughPupil;  ///< how many of them pass the eye, if there is one

    // stage 5
    InstrumentAnswers instruments;

    std::string failure;  ///< not empty: why nothing more will come
    bool complete = false;
};

/// The pixel of the eye's strip that the recorded run is about; none: it is about P.
inline std::optional<std::uint32_t> pixelOf(const LightAnswer& answer) {
    return answer.pathRun ? answer.asked.pixel : std::nullopt;
}

/// Of the recorded run's estimate: irradiance at P, radiance of a pixel.
inline const char* unitOf(const LightAnswer& answer) {
    return pixelOf(answer) ? "W/(m rad)" : "W/m";
}

/// One number for a colour in plots.
inline double gray(const Rgb& c) {
    return (c.x + c.y + c.z) / 3.0;
}

}  // namespace halfdisk
