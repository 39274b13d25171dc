// How does an estimator work until it has done enough? Passes until their number, the time, or Ctrl-C ends
// them.
#include "app/measurement.h"

#include <fmt/format.h>

#include "app/interruption.h"
#include "app/progress_bar.h"
#include "core/stopwatch.h"
#include "lessons/input_error.h"

namespace halfdisk {
namespace {

std::string counted(std::uint64_t passes) {
    return fmt::format("{} sample{}", passes, passes == 1 ? "" : "s");
}

/// Null if it was called off.
std::unique_ptr<Estimator> makeOrRefuse(const EstimatorInfo& info, const Problem& problem,
                                        const ParamValues& params) {
    try {
        if (const std::string refusal = refusalOf(info, problem, params); !refusal.empty())
            throw InputError(refusal);
        return info.make(problem, params);
    } catch (const Stopped&) {
        return nullptr;
    } catch (const std::invalid_argument& refusal) {
        throw InputError(refusal.what());
    }
}

/// Keeps the first pixel of every pass beside what another estimator does.
class Listing : public Estimator {
 public:
    Listing(const Estimator& estimator, std::vector<Rgb>& firstPixels)
        : estimator_(estimator), firstPixels_(firstPixels) {}

    void addPass(std::uint64_t pass, Picture& picture, Counts& counts) const override {
        estimator_.addPass(pass, picture, counts);
        firstPixels_[pass] = picture.front();  // each pass has a place of its own
    }

 private:
    const Estimator& estimator_;
    std::vector<Rgb>& firstPixels_;
};

Film renderListed(const Estimator& estimator, const Sensor& sensor, const RenderOptions& options,
                  std::vector<Rgb>* firstPixels) {
    if (firstPixels == nullptr) return render(estimator, sensor, options);
    firstPixels->resize(options.passes);
    const Film film = render(Listing(estimator, *firstPixels), sensor, options);
    firstPixels->resize(film.passes);
    return film;
}

double shareDone(std::uint64_t passes, double elapsed, const MeasureLimits& limits) {
    const double ofPasses = static_cast<double>(passes) / static_cast<double>(limits.passes);
    return limits.seconds ? std::max(ofPasses, elapsed / *limits.seconds) : ofPasses;
}

}  // namespace

Measurement measure(const EstimatorInfo& info, const Problem& problem, const ParamValues& params,
                    const MeasureLimits& limits, const std::function<bool()>& stop,
                    std::vector<Rgb>* firstPixels) {
    ProgressBar bar;
    const Interruption interruption([&bar] { bar.say("stopping; Ctrl-C again ends at once"); });
    const Stopwatch watch;
    const auto isInterrupted = [&] { return interruption.asked() || (stop && stop()); };

    Problem stoppable = problem;
    stoppable.stop = isInterrupted;
    Measurement measurement;
    const std::unique_ptr<Estimator> estimator = makeOrRefuse(info, stoppable, params);
    if (estimator && !isInterrupted()) {
        RenderOptions options;
        options.passes = limits.passes;
        options.threads = limits.threads;
        options.stop = [&] {
            return isInterrupted() || (limits.seconds && watch.seconds() >= *limits.seconds);
        };
        if (bar.isShown())
            options.progress = [&](const Film& film) {
                bar.tell(shareDone(film.passes, watch.seconds(), limits), watch.seconds(),
                         counted(film.passes));
            };
        measurement.film = renderListed(*estimator, problem.sensor, options, firstPixels);
    }
    measurement.interrupted = isInterrupted() && measurement.film.passes < limits.passes;
    measurement.seconds = watch.seconds();
    return measurement;
}

std::string howFar(const Measurement& measurement, const MeasureLimits& limits) {
    if (limits.seconds)
        return fmt::format("{} in {:.3g} of {:g} s", counted(measurement.film.passes), measurement.seconds,
                           *limits.seconds);
    return fmt::format("{} of {}", measurement.film.passes, counted(limits.passes));
}

}  // namespace halfdisk
