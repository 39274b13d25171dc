// What did an estimator that follows paths do, step by step? The observer that writes everything down, to be
// read forwards and backwards; recorder.h is castRay's own.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "light_ways.h"
#include "walk.h"

namespace halfdisk {

/// Where in the source a step was told: as a default argument, where its function is called.
struct SourceLine {
    std::string_view file{};  ///< as the compiler was given it
    int line = 0;             ///< counted from 1

    static constexpr SourceLine here(const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
        return {file, line};
    }
};

/// What happened.
enum class PathEventKind : std::uint8_t {
    start,    ///< a path begins, at the sensor or at a light
    fly,      ///< to the next wall, or out of the scene
    arrive,   ///< at a wall
    escape,   ///< into the environment
    depart,   ///< on from a wall
    end,      ///< nothing more of this path
    met,      ///< a lamp or the sky was met by chance
    asked,    ///< a light was drawn, and a shadow ray sent to it
    joined,   ///< two ends, or a wall and the sensor, were connected
    kept,     ///< a photon was stored
    lookedUp  ///< the photons around a place were counted
};

inline constexpr std::array<Named<PathEventKind>, 11> kPathEventKinds{{
    {PathEventKind::start, "start", "a path begins"},
    {PathEventKind::fly, "fly", "it flies to the next wall"},
    {PathEventKind::arrive, "arrive", "it arrives at a wall"},
    {PathEventKind::escape, "escape", "it leaves the scene"},
    {PathEventKind::depart, "depart", "it goes on from the wall"},
    {PathEventKind::end, "end", "it ends"},
    {PathEventKind::met, "met", "it met a light"},
    {PathEventKind::asked, "asked", "a light is asked"},
    {PathEventKind::joined, "joined", "two places are joined"},
    {PathEventKind::kept, "kept", "a photon is kept"},
    {PathEventKind::lookedUp, "lookedUp", "photons are looked up"},
}};

/// One step. Fields that a kind does not speak of keep their defaults.
struct PathEvent {
    PathEventKind kind = PathEventKind::start;
    Carried carried = Carried::radiance;  ///< radiance: from the sensor; power: from a light
    Ending ending = Ending::absorbed;     ///< of PathEventKind::end
    bool visible = false;                 ///< the way was free
    bool missed = false;                  ///< it met no wall: `to` lies one direction's length away
    bool delta = false;                   ///< a mirror's or glass's event
    std::uint32_t path = 0;               ///< counted from 0, in the order in which they began
    std::uint32_t vertex = 0;             ///< walls met so far
    std::uint32_t segment = kNoSegment;   ///< the wall, or the lamp
    std::uint32_t s = 0, t = 0;           ///< vertices from the light and from the sensor (joined)
    std::uint32_t photons = 0;            ///< counted (lookedUp)
    Vec2 from{0.0}, to{0.0};              ///< m
    double pdfAngle = 0.0;                ///< 1/rad, of a direction that was drawn; 0: there is none
    double weight = 1.0;                  ///< share of this way of finding the light (MIS)
    double radius = 0.0;                  ///< m, along the wall (lookedUp)
    Rgb throughput{0.0};                  ///< factor of radiance, or power (W)
    Rgb value{0.0};                       ///< added to the estimate
    Rgb sum{0.0};                         ///< of all values up to here
    SourceLine where{};                   ///< that told it
};

struct PathRecord {
    std::vector<PathEvent> events;
    std::uint32_t paths = 0;  ///< begun, the unrecorded ones included
    bool truncated = false;   ///< later paths were left out to stay within the limit
};

/// Keeps about `limit` events; what is found after that is only summed up. Of a sensor with many pixels it
/// may be about one alone: a pass then leaves out the paths, and what they find, that only others want.
class PathRecorder {
 public:
    explicit PathRecorder(std::size_t limit = 100'000, std::optional<std::uint32_t> pixel = std::nullopt)
        : limit_(limit), pixel_(pixel) {}

    bool wants(std::uint32_t pixel) const { return !pixel_ || *pixel_ == pixel; }
    bool wantsOnePixel() const { return pixel_.has_value(); }

    void start(Carried carried, Vec2 at, const Rgb& throughput, std::uint32_t segment,
               SourceLine where = SourceLine::here());
    void fly(const Ray& ray, double distance, const Rgb& throughput, SourceLine where);
    void arrive(const Arrival& here, SourceLine where);
    void escape(const Ray& ray, const Rgb& throughput, SourceLine where);
    void depart(const Arrival& here, const Scattered& way, SourceLine where);
    void end(Ending why, SourceLine where);
    /// A ray met a lamp, or the sky (no hit). `value` is what it adds, the share included.
    void met(const Ray& ray, const Hit& hit, double share, const Rgb& value,
             SourceLine where = SourceLine::here());
    void asked(Vec2 from, const AskedLight& light, const Rgb& value, SourceLine where = SourceLine::here());
    void joined(Vec2 from, Vec2 to, std::uint32_t s, std::uint32_t t, bool visible, double share,
                const Rgb& value, SourceLine where = SourceLine::here());
    void kept(Vec2 at, std::uint32_t segment, const Rgb& power, SourceLine where = SourceLine::here());
    void lookedUp(Vec2 at, std::uint32_t segment, double radius, std::uint32_t photons, const Rgb& value,
                  SourceLine where = SourceLine::here());

    /// Where a path is, other paths set out that find light for it, which counts for it times `throughput`.
    void branch(const Rgb& throughput) {
        branchedAt_ = now_;
        share_ = throughput;
    }
    /// Back to the path that branched.
    void rejoin() {
        now_ = branchedAt_;
        share_ = Rgb(1.0);
    }

    PathRecord take() { return std::move(record_); }

 private:
    PathEvent* append(PathEventKind kind, SourceLine where);  // null: left out
    void add(PathEvent* event, const Rgb& value);

    PathRecord record_;
    PathEvent branchedAt_;
    Rgb share_{1.0};
    PathEvent now_;  // what the next event inherits: the path, where it is, what it carries
    Rgb sum_{0.0};
    std::size_t limit_;
    std::optional<std::uint32_t> pixel_;
    bool full_ = false;
};

/// A visitor of walk() that also tells a recorder (may be null) what it sees.
template <class Visitor>
struct Watched {
    Visitor& visitor;
    PathRecorder* see;

    void fly(const Ray& ray, double distance, const Rgb& throughput, std::uint32_t scatterings,
             SourceLine where = SourceLine::here()) {
        if (see) see->fly(ray, distance, throughput, where);
        visitor.fly(ray, distance, throughput, scatterings);
    }
    void escape(const Ray& ray, const Rgb& throughput, std::uint32_t scatterings,
                SourceLine where = SourceLine::here()) {
        if (see) see->escape(ray, throughput, where);
        visitor.escape(ray, throughput, scatterings);
    }
    bool arrive(const Arrival& here, SourceLine where = SourceLine::here()) {
        if (see) see->arrive(here, where);
        return visitor.arrive(here);
    }
    void depart(const Arrival& here, const Scattered& way, SourceLine where = SourceLine::here()) {
        if (see) see->depart(here, way, where);
        visitor.depart(here, way);
    }
    void end(Ending why, SourceLine where = SourceLine::here()) {
        if (see) see->end(why, where);
        visitor.end(why);
    }
};
template <class Visitor>
Watched(Visitor&, PathRecorder*) -> Watched<Visitor>;

}  // namespace halfdisk
