#include "questions.h"

#include "hit_check.h"

namespace halfdisk {
namespace {

// m: what t may be off by in the unit box.
constexpr double kDoubleTolerance = 1e-9, kFloatTolerance = 1e-5;

/// Calls `work(first, count)` for pieces of at most `piece`.
template <class Work>
void inPieces(std::size_t first, std::size_t count, std::size_t piece, const Work& work) {
    for (; count > 0; first += std::min(count, piece), count -= std::min(count, piece))
        work(first, std::min(count, piece));
}

}  // namespace

Questions ask(Query query, const Scene& scene, std::size_t checked) {
    Questions questions;
    questions.query = query;
    questions.checked = checked;
    if (questions.isAny())
        questions.rays = pointPairs(scene, kPool, questions.tMax);
    else
        questions.rays =
            query == Query::fan ? halfDiskFans(scene, kPool / kFanRays) : incoherentRays(scene, kPool);
    questions.floats = floatRays(questions.rays, questions.tMax);
    for (std::size_t i = 0; i < checked; ++i)
        if (questions.isAny())
            questions.occluded.push_back(bruteOccluded(scene, questions.rays[i], questions.tMax[i]));
        else
            questions.hits.push_back(bruteClosest(scene, questions.rays[i]));
    return questions;
}

Answers::Answers(const Questions& questions)
    : questions_(questions), hits_(kPool), peerHits_(kPool), occluded_(kPool) {}

void Answers::by(const SegmentIndex& index, std::size_t first, std::size_t count) {
    const std::span rays(questions_.rays);
    const std::span tMax(questions_.tMax);
    const std::span hits(hits_);
    const std::span occluded(occluded_);
    switch (questions_.query) {
        case Query::closest:
            // In place, as `const Hit hit = ...` would be: an assignment copies.
            for (std::size_t i = first; i < first + count; ++i) new (&hits[i]) Hit(index.closestHit(rays[i]));
            break;
        case Query::closestBatch:
            inPieces(first, count, kBatch, [&](std::size_t at, std::size_t size) {
                index.closestHits(rays.subspan(at, size), hits.subspan(at, size));
            });
            break;
        case Query::any:
            for (std::size_t i = first; i < first + count; ++i)
                occluded[i] = index.occluded(rays[i], tMax[i]);
            break;
        case Query::anyBatch:
            inPieces(first, count, kBatch, [&](std::size_t at, std::size_t size) {
                index.occluded(rays.subspan(at, size), tMax.subspan(at, size), occluded.subspan(at, size));
            });
            break;
        case Query::fan:
            inPieces(first, count, kFanRays, [&](std::size_t at, std::size_t size) {
                index.closestHitsFan(rays.subspan(at, size), hits.subspan(at, size));
            });
            break;
    }
}

void Answers::by(const Peer& peer, std::size_t first, std::size_t count, bool packets) {
    const auto rays = std::span(questions_.floats).subspan(first, count);
    const auto hits = std::span(peerHits_).subspan(first, count);
    if (questions_.isAny())
        peer.occluded(rays, std::span(occluded_).subspan(first, count));
    else if (packets)
        peer.closestPackets(rays, hits);
    else
        peer.closest(rays, hits);
}

void Answers::spoil() {
    for (std::size_t i = 0; i < questions_.checked; ++i) {
        const std::uint32_t wrong = questions_.isAny() || questions_.hits[i] ? kNoSegment : std::uint32_t{0};
        hits_[i] = {wrong, -1.0};
        peerHits_[i] = {wrong, -1.0f};
        if (questions_.isAny()) occluded_[i] = questions_.occluded[i] ? 0 : 1;
    }
}

std::size_t Answers::differences(bool ofPeer) const {
    const std::size_t checked = questions_.checked;
    if (questions_.isAny()) return countDifferences(std::span(occluded_).first(checked), questions_.occluded);
    if (ofPeer)
        return countDifferences(std::span(peerHits_).first(checked), questions_.hits, kFloatTolerance);
    return countDifferences(std::span(hits_).first(checked), questions_.hits, kDoubleTolerance);
}

}  // namespace halfdisk
