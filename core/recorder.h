// What did castRay do, step by step? The observer that writes everything down, to be read forwards and
// backwards.
#pragma once

#include <atomic>
#include <utility>
#include <vector>

#include "tracing.h"

namespace halfdisk {

/// What happened, in the order of one pass through gatherLight.
enum class EventKind : std::uint8_t {
    meet,
    enter,
    light,
    sample,
    direction,
    arrival,
    accumulate,
    average,
    leave
};

/// One step of the recursion. Fields that a kind does not speak of keep their defaults.
struct Event {
    EventKind kind = EventKind::enter;
    std::uint32_t depth = 0;             ///< of the half-disk that is being gathered
    std::uint32_t call = 0;              ///< index into Record::calls
    std::uint32_t n = 0;                 ///< which sample, or which draw of a light
    std::uint32_t light = 0;             ///< which light (EventKind::light)
    std::uint32_t segment = kNoSegment;  ///< the wall met
    double theta = 0.0;                  ///< rad, from the tangent
    double pdfAngle = 0.0;               ///< 1 / rad
    bool visible = false;                ///< the shadow ray got through
    bool onward = false;                 ///< the ray comes from a mirror or glass (EventKind::meet)
    bool missed = false;                 ///< the ray met no wall: `to` lies one direction's length away
    Vec2 from{0.0}, to{0.0};             ///< ends of the ray, m
    Vec2 direction{0.0};                 ///< unit
    Rgb value{0.0};  ///< what came back, was added, or is returned; of a light: its share of the sum
    Rgb sum{0.0};    ///< running sum after this step
};

inline constexpr std::uint32_t kNoCall = 0xFFFFFFFF;

/// One half-disk that was gathered: a node of the tree of calls.
struct Call {
    std::uint32_t parent = kNoCall;  ///< index of the call whose sample led here
    std::uint32_t sample = 0;        ///< which of the parent's samples
    std::uint32_t depth = 0;
    ShadedPoint at;
    std::uint32_t firstEvent = 0;  ///< its `enter`
    std::uint32_t lastEvent = 0;   ///< its `leave`
};

struct Record {
    std::vector<Event> events;
    std::vector<Call> calls;
    std::uint64_t rays = 0;
    bool truncated =
        false;  ///< deeper steps were left out to stay within the limit; those at depth 0 are all here
};

/// The line of the published listing that a step belongs to.
int listingLine(EventKind kind);

/// Keeps at most about `limit` events below depth 0, and all of depth 0. `cancelled` may be null.
class Recorder {
 public:
    explicit Recorder(std::size_t limit = 200'000, const std::atomic<bool>* cancelled = nullptr)
        : limit_(limit), cancelled_(cancelled) {}

    bool keepGoing() const { return !cancelled_ || !cancelled_->load(std::memory_order_relaxed); }
    void meet(const Ray& ray, const Hit& hit, std::uint32_t depth, std::uint64_t rays);
    void enter(const ShadedPoint& at, std::uint32_t depth);
    void light(std::uint32_t light, std::uint32_t n, const LightSample& sample, double visible,
               const Rgb& sum);
    void sample(std::uint32_t n, double theta, double pdfAngle);
    void direction(std::uint32_t n, const Ray& ray);
    void arrival(std::uint32_t n, const Ray& ray, const Radiance& sampleColor);
    void accumulate(std::uint32_t n, const Rgb& added, const Rgb& sum);
    void average(const Rgb& value);
    void leave(const ShadedPoint& at, const Irradiance& gathered);

    Record take() { return std::move(record_); }

 private:
    struct Frame {
        std::uint32_t call;  // kOmitted: this half-disk is left out
        std::uint32_t n = 0;
        std::uint32_t segment = kNoSegment;
        Vec2 to{0.0};
        bool missed = true;
        Rgb lightSum{0.0};
    };
    bool omitted() const { return open_.empty() || open_.back().call == kOmitted; }
    Event& append(EventKind kind);

    static constexpr std::uint32_t kOmitted = 0xFFFFFFFF;
    Record record_;
    std::vector<Frame> open_;  // half-disks that were entered and not left
    std::size_t limit_;
    const std::atomic<bool>* cancelled_;
};

}  // namespace halfdisk
