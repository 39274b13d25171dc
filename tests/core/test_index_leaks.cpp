// Does any of millions of rays slip out of a closed room, or meet two walls where it can only meet one?
#include <doctest/doctest.h>

#include "core/estimate.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

constexpr std::array kMethods{IndexMethod::bruteForce, IndexMethod::tree, IndexMethod::grid};
constexpr int kSides = 64;

/// The room about 0, and far from it, small and huge.
const std::vector<Placing> kPlacings = {
    {1.0, Vec2(0.0)}, {1.0, Vec2(1000.0)}, {1e-3, Vec2(1000.0)}, {1e6, Vec2(1000.0)}};

struct Faults {
    std::uint64_t escapes = 0;        ///< no wall was met, or one from outside
    std::uint64_t doubleHits = 0;     ///< behind that wall another one
    std::uint64_t disagreements = 0;  ///< between one by one and batches
};

/// `rays` start inside a convex room: each has one wall to meet, from its front. All are asked in batches,
/// every tenth alone too.
void countFaults(const SegmentIndex& index, const std::vector<Ray>& rays, Faults& faults) {
    std::vector<Hit> hits(rays.size()), beyond(rays.size());
    std::vector<Ray> onwards = rays;
    std::vector<std::uint8_t> hidden(rays.size(), 0), hiddenBeyond(rays.size(), 0);
    const std::vector<double> noEnd(rays.size(), kInfinity);
    index.closestHits(rays, hits);
    index.occluded(rays, noEnd, hidden);
    for (std::size_t i = 0; i < rays.size(); ++i) onwards[i].skip = hits[i].segment;
    index.closestHits(onwards, beyond);
    index.occluded(onwards, noEnd, hiddenBeyond);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i] || !hits[i].front || !hidden[i])
            ++faults.escapes;
        else if (beyond[i] || hiddenBeyond[i])
            ++faults.doubleHits;
        if (i % 10 != 0) continue;
        const Hit alone = index.closestHit(rays[i]);
        const bool same = alone.segment == hits[i].segment && alone.t == hits[i].t &&
                          index.occluded(rays[i], kInfinity) == (hidden[i] != 0) &&
                          index.occluded(onwards[i], kInfinity) == (hiddenBeyond[i] != 0);
        if (!same) ++faults.disagreements;
    }
}

/// `count` rays from all over the room, into all directions or at its vertices.
std::vector<Ray> raysFromInside(const std::vector<Vec2>& vertices, const Placing& placing, std::size_t count,
                                bool aimed, Random& random) {
    std::vector<Ray> rays;
    while (rays.size() < count) {
        // The inscribed circle's radius is cos(pi / 64) = 0.9988.
        const Vec2 place = random.pointIn(-0.998, 0.998);
        if (glm::dot(place, place) > 0.998 * 0.998) continue;
        const Vec2 from = placing.scale * place + placing.offset;
        if (!aimed) {
            rays.push_back({from, random.direction()});
            continue;
        }
        const Vec2 way = vertices[static_cast<std::size_t>(random.integer(0, kSides - 1))] - from;
        rays.push_back({from, rays.size() % 2 == 0 ? way : glm::normalize(way)});
    }
    return rays;
}

void checkRoom(std::uint64_t randomRays, std::uint64_t aimedRays) {
    Random random(1);
    constexpr std::size_t kBatch = 10'000;
    for (const Placing& placing : kPlacings) {
        CAPTURE(placing.scale);
        CAPTURE(placing.offset.x);
        const auto vertices = moved(regularPolygon(kSides), placing.scale, placing.offset);
        const Scene room = polygonRoom(vertices);
        std::vector<SegmentIndex> indices;
        for (const IndexMethod method : kMethods) indices.emplace_back(room, method);
        std::vector<Faults> faults(indices.size());
        for (std::uint64_t first = 0; first < randomRays + aimedRays; first += kBatch) {
            const auto rays = raysFromInside(vertices, placing, kBatch, first < aimedRays, random);
            for (std::size_t k = 0; k < indices.size(); ++k) countFaults(indices[k], rays, faults[k]);
        }
        for (std::size_t k = 0; k < indices.size(); ++k) {
            CAPTURE(static_cast<int>(kMethods[k]));
            CHECK(faults[k].escapes == 0);
            CHECK(faults[k].doubleHits == 0);
            CHECK(faults[k].disagreements == 0);
        }
    }
}

/// A ray that bounces about: from wherever it lands, into a random direction.
void checkBounces(const std::vector<Vec2>& shape, std::uint64_t bounces) {
    Random random(2);
    for (const Placing& placing : kPlacings) {
        CAPTURE(placing.scale);
        CAPTURE(placing.offset.x);
        const Scene room = polygonRoom(moved(shape, placing.scale, placing.offset));
        for (const IndexMethod method : kMethods) {
            CAPTURE(static_cast<int>(method));
            const SegmentIndex index(room, method);
            std::uint64_t leaks = 0, selfHits = 0;
            ShadedPoint at = shadedPointOn(index, 0, 0.5);
            for (std::uint64_t bounce = 0; bounce < bounces; ++bounce) {
                // Every fourth all but along the wall.
                const double theta = bounce % 4 ? random.in(0.0, kPi) : std::pow(10.0, random.in(-17.0, 0.0));
                const Vec2 direction = frameFromNormal(at.N).toWorld(
                    bounce % 8 ? std::cos(theta) : -std::cos(theta), std::sin(theta));
                const Hit hit = index.closestHit(rayFrom(index, at, direction));
                if (hit.segment == at.segment) ++selfHits;
                if (!hit || !hit.front) {
                    ++leaks;
                    at = shadedPointOn(index, 0, 0.5);
                    continue;
                }
                at = shadedPointOn(index, hit.segment, hit.u);
            }
            CHECK(leaks == 0);
            CHECK(selfHits == 0);
        }
    }
}

}  // namespace

TEST_CASE("index: 10^6 random rays and 10^5 at vertices leave a closed room of 64 walls once") {
    checkRoom(1'000'000, 100'000);
}

TEST_CASE("index: 250 000 bounces in a closed room neither leak nor meet their own wall") {
    checkBounces(regularPolygon(kSides), 250'000);
    checkBounces(furnacePolygon(), 250'000);
}

TEST_CASE("long: 10^7 random rays and 10^6 at vertices leave a closed room of 64 walls once" *
          doctest::skip()) {
    checkRoom(10'000'000, 1'000'000);
}

TEST_CASE("long: 2.5 million bounces in a closed room neither leak nor meet their own wall" *
          doctest::skip()) {
    checkBounces(regularPolygon(kSides), 2'500'000);
    checkBounces(furnacePolygon(), 2'500'000);
}
