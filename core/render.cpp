#include "render.h"

#include "parallel.h"

namespace halfdisk {
namespace {

// So many paths make a chunk worth a thread's while.
constexpr double kChunkPaths = 4096.0;

// Films that wait to be merged may take so much memory, and two for each thread in any case.
constexpr std::uint64_t kMostWaitingBytes = 64 << 20;

std::uint64_t mostAhead(std::uint64_t pixels, unsigned threads) {
    const std::uint64_t film = std::max<std::uint64_t>(1, pixels) * 2 * sizeof(Rgb);
    return std::max(2 * std::uint64_t{threads}, std::min(kMostWaitingBytes / film, kMostAhead));
}

// The passes of one chunk.
struct Part {
    Film film;
    bool whole = true;  // false: called off on the way
};

}  // namespace

Film render(const Estimator& estimator, const Sensor& sensor, const RenderOptions& options) {
    const std::uint64_t pixels = pixelCount(sensor);
    const double paths = static_cast<double>(pixels) + estimator.workPerPass();
    const auto passesPerChunk = static_cast<std::uint64_t>(std::max(1.0, kChunkPaths / paths));
    const std::uint64_t chunks = (options.passes + passesPerChunk - 1) / passesPerChunk;

    std::atomic<bool> stopped{false};
    const auto work = [&](std::uint64_t chunk) {
        Part part;
        Picture picture(pixels);
        const std::uint64_t end = std::min((chunk + 1) * passesPerChunk, options.passes);
        try {
            for (std::uint64_t pass = chunk * passesPerChunk; pass < end; ++pass) {
                std::fill(picture.begin(), picture.end(), Rgb(0.0));
                Counts counts;
                estimator.addPass(options.firstPass + pass, picture, counts);
                part.film.add(picture);
                part.film.counts.merge(counts);
            }
        } catch (const Stopped&) {
            part.whole = false;
        }
        if (!part.whole || (options.stop && options.stop())) stopped = true;
        return part;
    };
    Film film;
    film.pixels.reset(pixels);
    bool whole = true;  // no pass is left out so far
    const auto merge = [&](const Part& part) {
        if (!whole) return;
        whole = part.whole;
        if (part.film.passes == 0) return;
        film.merge(part.film);
        if (options.progress) options.progress(film);
    };
    forChunksInOrder(chunks, options.threads, &stopped, work, merge, mostAhead(pixels, options.threads));
    return film;
}

}  // namespace halfdisk
