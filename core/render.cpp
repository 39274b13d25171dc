#include "render.h"

#include "parallel.h"

namespace halfdisk {
namespace {

// So many paths make a chunk worth a thread's while.
constexpr double kChunkPaths = 4096.0;

}  // namespace

Film render(const Estimator& estimator, const Sensor& sensor, const RenderOptions& options) {
    const std::uint64_t pixels = pixelCount(sensor);
    const double paths = static_cast<double>(pixels) + estimator.workPerPass();
    const auto passesPerChunk = static_cast<std::uint64_t>(std::max(1.0, kChunkPaths / paths));
    const std::uint64_t chunks = (options.passes + passesPerChunk - 1) / passesPerChunk;

    std::atomic<bool> stopped{false};
    const auto work = [&](std::uint64_t chunk) {
        Film film;
        Picture picture(pixels);
        const std::uint64_t end = std::min((chunk + 1) * passesPerChunk, options.passes);
        for (std::uint64_t pass = chunk * passesPerChunk; pass < end; ++pass) {
            std::fill(picture.begin(), picture.end(), Rgb(0.0));
            estimator.addPass(options.firstPass + pass, picture, film.counts);
            film.add(picture);
        }
        if (options.stop && options.stop()) stopped = true;
        return film;
    };
    Film film;
    film.pixels.resize(pixels);
    const auto merge = [&](const Film& part) {
        film.merge(part);
        if (options.progress) options.progress(film);
    };
    forChunksInOrder(chunks, options.threads, &stopped, work, merge);
    return film;
}

}  // namespace halfdisk
