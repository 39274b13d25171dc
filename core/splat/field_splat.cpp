#include "core/splat/field_splat.h"

#include <algorithm>

#include "core/field_cells.h"

namespace halfdisk {
namespace {

// A flight is drawn when so many wait: each band then comes near the processor once for all of them.
constexpr std::size_t kMostRuns = 16384;
constexpr std::ptrdiff_t kBandBytes = 512 << 10;

// To wait is not worth while for a shorter flight.
constexpr std::int32_t kFewSteps = 12;

// Of so many, in one band, each takes some microseconds.
constexpr std::size_t kRunsPerQuestion = 256;

// Of a direction that hardly goes across: so many steps for a cell, and no overflow yet.
constexpr double kLeastSlope = 1e-200;

constexpr int kCellNumbers = 4;  // red, green, blue, and one unused: whole vectors

// Rows begin in different sets of the cache whatever the width: an odd number of cache lines apart.
std::ptrdiff_t strideOf(std::int32_t width) {
    const std::ptrdiff_t cells = width + 1;
    return kCellNumbers * (cells + (6 - cells % 4) % 4);
}

// `most` as a number of steps that fit into `length`, where that is not too many.
std::int32_t stepsWithin(double length, std::int32_t most) {
    return length < most ? static_cast<std::int32_t>(length) : most;
}

bool isOrdinary(const Rgb& c) {
    return isFinite(c) && c.x >= 0.0 && c.y >= 0.0 && c.z >= 0.0;
}

}  // namespace

// The part of a flight within the field, in cells: x to the right from the left edge, y down from the upper
// one. It never rises; where the light did, it is turned round.
struct FieldSplat::Flight {
    Vec2 start{0.0};
    Vec2 speed{0.0};      // cells per metre
    double metres = 0.0;  // 0: none
};

// The same, seen along the axis that it goes faster on: from step to step (rows, or columns), across the
// cells of each.
struct FieldSplat::Steps {
    double place, speed;         // along the steps: ahead
    double across, acrossSpeed;  // no faster
    std::int32_t steps, cells;   // of the field: how many steps, and cells across
    std::int32_t side;           // 0: rows; 1 or -1: columns, from the left or from the right

    std::int32_t at(std::int32_t step) const { return side < 0 ? steps - 1 - step : step; }
};

FieldSplat::FieldSplat(const Field& field, Picture& picture, const StopQuestion& stop, SplatKernel kernel)
    : field_(field),
      picture_(&picture),
      stop_(&stop),
      kernel_(kernel),
      cellsPerMetre_(Vec2(field.width, field.height) / (field.max - field.min)),
      perArea_(cellsPerMetre_.x * cellsPerMetre_.y),
      width_(static_cast<std::int32_t>(field.width)),
      height_(static_cast<std::int32_t>(field.height)),
      stride_(strideOf(width_)) {
    const std::ptrdiff_t rowBytes = stride_ * static_cast<std::ptrdiff_t>(sizeof(double));
    bandRows_ = static_cast<std::int32_t>(
        std::clamp<std::ptrdiff_t>(kBandBytes / rowBytes, 1, std::max(1, height_ - 1)));
    cells_.resize(static_cast<std::size_t>(stride_ * (bandRows_ + 1)) * sizeof(double) / sizeof(CacheLine) +
                  1);
    runs_.reserve(kMostRuns);
}

FieldSplat::Flight FieldSplat::clipped(const Ray& ray, double distance) const {
    double enter = 0.0, exit = distance;
    for (int axis = 0; axis < 2; ++axis) {
        const double speed = ray.direction[axis], place = ray.origin[axis];
        if (speed == 0.0) {
            if (place < field_.min[axis] || place >= field_.max[axis]) return {};
            continue;
        }
        const double a = (field_.min[axis] - place) / speed, b = (field_.max[axis] - place) / speed;
        enter = std::max(enter, std::min(a, b));
        exit = std::min(exit, std::max(a, b));
    }
    if (!(enter < exit)) return {};
    const bool rises = ray.direction.y > 0.0;
    const Vec2 P = ray.origin + (rises ? exit : enter) * ray.direction;
    // Rounding must not put it outside. In this order a NaN turns to 0.
    const auto inside = [](double place, double most) { return std::max(0.0, std::min(place, most)); };
    Flight flight;
    flight.start = {inside((P.x - field_.min.x) * cellsPerMetre_.x, width_),
                    inside((field_.max.y - P.y) * cellsPerMetre_.y, height_)};
    flight.speed = (rises ? -1.0 : 1.0) * Vec2(ray.direction.x, -ray.direction.y) * cellsPerMetre_;
    flight.metres = exit - enter;
    return flight;
}

FieldSplat::Steps FieldSplat::stepsOf(const Flight& flight) const {
    const Vec2 start = flight.start, speed = flight.speed;
    if (speed.y >= std::abs(speed.x)) return {start.y, speed.y, start.x, speed.x, height_, width_, 0};
    if (speed.x > 0.0) return {start.x, speed.x, start.y, speed.y, width_, height_, 1};
    return {width_ - start.x, -speed.x, start.y, speed.y, width_, height_, -1};
}

void FieldSplat::add(const Ray& ray, double distance, const Rgb& power, Counts& counts) {
    const Flight flight = clipped(ray, distance);
    if (flight.metres == 0.0) return;
    const Rgb perMetre = power * perArea_;
    if (addSteps(stepsOf(flight), flight.metres, perMetre)) return;
    forCells(field_, ray, distance, [&](std::uint32_t pixel, double from, double to) {
        addTo(*picture_, pixel, perMetre * (to - from), counts);
    });
}

bool FieldSplat::addSteps(const Steps& flight, double metres, const Rgb& perMetre) {
    const double metresPerStep = 1.0 / flight.speed, slope = flight.acrossSpeed * metresPerStep;
    const double perCell = 1.0 / std::max(std::abs(slope), kLeastSlope);
    const Rgb perStep = perMetre * metresPerStep;
    if (flight.steps < 2 || flight.cells < 2 || !isOrdinary(perStep)) return false;

    const std::int32_t step = std::min(static_cast<std::int32_t>(flight.place), flight.steps - 1);
    const double ahead = step + 1.0 - flight.place;  // cells
    const double first = std::min(ahead * metresPerStep, metres), rest = metres - first;
    const std::int32_t count = stepsWithin(rest * flight.speed, flight.steps - 1 - step);
    const double next = flight.across + slope * ahead, last = rest - count * metresPerStep;
    const FlightRun run{.power = {perStep.x, perStep.y, perStep.z, 0.0},
                        .place = next + std::min(slope, 0.0),
                        .slope = slope,
                        .perCell = perCell,
                        .at = flight.at(step + 1),
                        .count = count,
                        .done = 0,
                        .side = flight.side};
    // Light from so far away that rounding puts it anywhere.
    const auto isNear = [&](double place) { return place > -1.0 && place < flight.cells + 1.0; };
    if (count > 0 && !(isNear(run.place) && isNear(run.place + slope * (count - 1)))) return false;

    const auto addPart = [&](double length, std::int32_t at, double from) {
        const double place = from + std::min(flight.acrossSpeed * length, 0.0);
        addPiece(flight, perMetre, length, at, place, metresPerStep * perCell);
    };
    addPart(first, step, flight.across);
    if (last > 0.0) addPart(last, std::min(step + 1 + count, flight.steps - 1), next + slope * count);
    if (count > kFewSteps) {
        addRun(run);
    } else {
        for (std::int32_t j = 0; j < count; ++j)
            addPiece(flight, perMetre, metresPerStep, step + 1 + j, run.place + slope * j,
                     metresPerStep * perCell);
    }
    return true;
}

// A part of a step, of `length` metres.
void FieldSplat::addPiece(const Steps& flight, const Rgb& perMetre, double length, std::int32_t step,
                          double place, double metresPerCell) {
    const std::int32_t cell = std::min(static_cast<std::int32_t>(std::max(0.0, place)), flight.cells - 2);
    const double mine = std::clamp((cell + 1.0 - place) * metresPerCell, 0.0, length);
    const auto column = static_cast<std::size_t>(flight.side == 0 ? cell : flight.at(step));
    const auto row = static_cast<std::size_t>(flight.side == 0 ? step : cell);
    Rgb* const first = picture_->data() + row * field_.width + column;
    first[0] += perMetre * mine;
    first[flight.side == 0 ? 1 : field_.width] += perMetre * (length - mine);
}

void FieldSplat::addRun(const FlightRun& run) {
    runs_.push_back(run);
    if (runs_.size() == kMostRuns) finish();
}

void FieldSplat::finish() {
    if (runs_.empty()) return;
    SplatBand band{.cells = cells_.front().numbers,
                   .stride = stride_,
                   .width = width_,
                   .height = height_,
                   .firstRow = 0,
                   .endRow = 0,
                   .isLast = false};
    for (; !band.isLast; band.firstRow = band.endRow) {
        band.endRow = std::min(band.firstRow + bandRows_, height_ - 1);
        band.isLast = band.endRow == height_ - 1;
        for (std::size_t first = 0; first < runs_.size(); first += kRunsPerQuestion) {
            throwIfStopped(*stop_);
            kernel_(band, runs_.data() + first, std::min(kRunsPerQuestion, runs_.size() - first));
        }
        addBand(band);
    }
    runs_.clear();
}

// To the picture, and makes it empty for the next. A step across two rows may have reached the row below.
void FieldSplat::addBand(const SplatBand& band) {
    for (std::int32_t row = band.firstRow; row <= band.endRow; ++row) {
        double* from = band.cells + band.stride * (row - band.firstRow);
        Rgb* to = picture_->data() + std::size_t{field_.width} * static_cast<std::size_t>(row);
        for (std::uint32_t column = 0; column < field_.width; ++column, from += kCellNumbers) {
            to[column] += Rgb(from[0], from[1], from[2]);
            from[0] = from[1] = from[2] = 0.0;
        }
    }
}

}  // namespace halfdisk
