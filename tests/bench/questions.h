// What is asked of an index and of its peers, and do they answer right? Shared by the contest and by Google
// Benchmark.
#pragma once

#include "peers.h"
#include "required.h"

namespace halfdisk {

inline constexpr std::size_t kPool = 32'768;  ///< rays: small enough for the second-level cache
inline constexpr std::size_t kBatch = 4'096;  ///< rays that are asked at once

/// The rays of one kind of question, and what is true of the first of them.
struct Questions {
    Query query = Query::closest;
    std::vector<Ray> rays;
    std::vector<double> tMax;  ///< of any hit
    std::vector<FloatRay> floats;
    std::size_t checked = 0;             ///< so many answers are known
    std::vector<Hit> hits;               ///< wall by wall
    std::vector<std::uint8_t> occluded;  ///< of any hit, instead

    bool isAny() const { return query == Query::any || query == Query::anyBatch; }
    /// Rays that can't be parted.
    std::size_t block() const {
        if (query == Query::fan) return kFanRays;
        return query == Query::closestBatch || query == Query::anyBatch ? kBatch : 1;
    }
};

/// kPool rays. `checked` of them, a multiple of a fan's rays, are answered wall by wall.
Questions ask(Query query, const Scene& scene, std::size_t checked);

/// Answers to one kind of question.
class Answers {
 public:
    explicit Answers(const Questions& questions);

    /// Rays first ... first + count - 1, in the way that the question says.
    void by(const SegmentIndex& index, std::size_t first, std::size_t count);
    void by(const Peer& peer, std::size_t first, std::size_t count, bool packets = false);

    /// Makes all that is checked wrong.
    void spoil();
    std::size_t differences(bool ofPeer) const;

 private:
    const Questions& questions_;
    std::vector<Hit> hits_;
    std::vector<PeerHit> peerHits_;
    std::vector<std::uint8_t> occluded_;
};

}  // namespace halfdisk
