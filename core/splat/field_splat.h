// How does light that flies through a field get into its cells? By the exact length of the flight in each,
// thousands of flights together, band by band of rows, so that all that is touched lies near the processor.
#pragma once

#include <vector>

#include "core/film.h"
#include "core/sensor.h"
#include "core/splat/flight_run.h"
#include "core/stop.h"

namespace halfdisk {

/// Adds flights to the picture of a field. The same flights in the same order give the same bits.
class FieldSplat {
 public:
    /// Keeps pointers to the picture and the question. `kernel`: for tests and benchmarks.
    FieldSplat(const Field& field, Picture& picture, const StopQuestion& stop,
               SplatKernel kernel = bestSplatKernel());

    /// Light of `power` (W) flies `distance` metres (or to infinity) along the ray (of unit direction): it
    /// adds power * length / area of the cell to each cell that it crosses. The lengths of a flight add up to
    /// that of its part within the field. What is not finite or negative is counted, cell by cell, as addTo
    /// does. Throws Stopped if `stop` says so.
    void add(const Ray& ray, double distance, const Rgb& power, Counts& counts);

    /// Brings the last flights into the picture: before that it is not complete.
    void finish();

 private:
    struct Flight;
    struct Steps;
    Flight clipped(const Ray& ray, double distance) const;
    Steps stepsOf(const Flight& flight) const;
    bool addSteps(const Steps& flight, double metres, const Rgb& perMetre);  // false: it takes another way
    void addPiece(const Steps& flight, const Rgb& perMetre, double length, std::int32_t step, double place,
                  double metresPerCell);
    void addRun(const FlightRun& run);
    void addBand(const SplatBand& band);

    Field field_;
    Picture* picture_;
    const StopQuestion* stop_;
    SplatKernel kernel_;
    Vec2 cellsPerMetre_;
    double perArea_;  // 1/m^2
    std::int32_t width_, height_;
    std::ptrdiff_t stride_;
    std::int32_t bandRows_;
    std::vector<FlightRun> runs_;
    struct alignas(64) CacheLine {
        double numbers[8];
    };
    std::vector<CacheLine> cells_;  // of a band, and of the row below it
};

}  // namespace halfdisk
