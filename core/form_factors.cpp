#include "form_factors.h"

#include <algorithm>

namespace halfdisk {
namespace {

std::vector<Blocker> blockersIn(const Hull& hull, std::span<const Strand> walls) {
    std::vector<Blocker> blockers;
    for (const Strand& wall : walls)
        if (const auto part = hull.partOf(wall)) blockers.push_back(*part);
    return blockers;
}

/// A corner that a visible part may end at, and the other end of its wall.
struct Corner {
    Vec2 at, other;
};

bool lessInPlace(const Corner& p, const Corner& q) {
    return p.at.x < q.at.x || (p.at.x == q.at.x && p.at.y < q.at.y);
}

/// Where two walls meet and go on to either side as seen from everywhere on `from`, no view ends.
bool isInnerCorner(const Corner& one, const Corner& two, const Strand& from) {
    const auto side = [&](Vec2 viewer, const Corner& corner) {
        return cross(corner.at - viewer, corner.other - corner.at);
    };
    const double oneA = side(from.a, one), oneB = side(from.b, one);
    const double twoA = side(from.a, two), twoB = side(from.b, two);
    return (oneA > 0.0 && oneB > 0.0 && twoA < 0.0 && twoB < 0.0) ||
           (oneA < 0.0 && oneB < 0.0 && twoA > 0.0 && twoB > 0.0);
}

std::vector<Vec2> viewEnds(const std::vector<Blocker>& blockers, const Strand& from) {
    std::vector<Corner> corners;
    for (const Blocker& wall : blockers) {
        if (wall.cornerA) corners.push_back({wall.at.a, wall.at.b});
        if (wall.cornerB) corners.push_back({wall.at.b, wall.at.a});
    }
    std::sort(corners.begin(), corners.end(), lessInPlace);
    std::vector<Vec2> ends;
    for (std::size_t i = 0; i < corners.size();) {
        std::size_t next = i + 1;
        while (next < corners.size() && corners[next].at == corners[i].at) ++next;
        if (next - i != 2 || !isInnerCorner(corners[i], corners[i + 1], from)) ends.push_back(corners[i].at);
        i = next;
    }
    for (std::size_t i = 0; i < blockers.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const Strand &one = blockers[i].at, &two = blockers[k].at;
            const Vec2 e = one.b - one.a, f = two.b - two.a;
            const double denominator = cross(e, f);
            if (denominator == 0.0) continue;
            const double u = cross(two.a - one.a, f) / denominator;
            const double v = cross(two.a - one.a, e) / denominator;
            if (u > 0.0 && u < 1.0 && v > 0.0 && v < 1.0) ends.push_back(one.a + u * e);
        }
    return ends;
}

/// Adds where the line through P and Q meets `from` inside, 0 ... 1 along it.
void addCut(const Strand& from, Vec2 P, Vec2 Q, std::vector<double>& cuts) {
    const Vec2 edge = from.b - from.a;
    const double denominator = cross(edge, Q - P);
    if (denominator == 0.0) return;
    const double u = cross(P - from.a, Q - P) / denominator;
    if (u > 0.0 && u < 1.0) cuts.push_back(u);
}

/// Places along `from` between which every visible part of `to` ends at the same corners; 0 ... 1.
std::vector<double> cutsOf(const Strand& from, const Strand& to, const std::vector<Blocker>& blockers) {
    const std::vector<Vec2> ends = viewEnds(blockers, from);
    std::vector<double> cuts{0.0, 1.0};
    for (std::size_t i = 0; i < ends.size(); ++i) {
        addCut(from, ends[i], to.a, cuts);
        addCut(from, ends[i], to.b, cuts);
        for (std::size_t k = 0; k < i; ++k) addCut(from, ends[i], ends[k], cuts);
    }
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

/// A direction by its cosine to from.a->from.b, and the corner that it points to.
struct Edge {
    double cosine;
    Vec2 corner;
};
struct Shadow {
    Edge first, last;  // first.cosine >= last.cosine: counter-clockwise
};

/// Integral over the stretch x...y of the cosine towards V.
double cosineAlong(Vec2 x, Vec2 y, Vec2 V) {
    return glm::length(x - V) - glm::length(y - V);
}

/// Exchange length of the stretch x...y, within which the same corners bound what is visible of `to`.
double stretchExchange(Vec2 x, Vec2 y, const Strand& to, const std::vector<Blocker>& blockers,
                       std::vector<Shadow>& shadows) {
    const Vec2 viewer = (x + y) / 2.0, along = glm::normalize(y - x);
    const auto edgeAt = [&](Vec2 V) {
        return Edge{glm::dot(V - viewer, along) / glm::length(V - viewer), V};
    };
    const Edge first = edgeAt(to.a), last = edgeAt(to.b);
    shadows.clear();
    for (const Blocker& wall : blockers) {
        Shadow shadow{edgeAt(wall.at.a), edgeAt(wall.at.b)};
        if (shadow.first.cosine < shadow.last.cosine) std::swap(shadow.first, shadow.last);
        if (shadow.last.cosine < first.cosine && shadow.first.cosine > last.cosine) shadows.push_back(shadow);
    }
    std::sort(shadows.begin(), shadows.end(),
              [](const Shadow& p, const Shadow& q) { return p.first.cosine > q.first.cosine; });

    double sum = 0.0;
    Edge lit = first;  // from here on `to` is visible, up to the next shadow
    const auto addUpTo = [&](const Edge& end) {
        if (end.cosine < lit.cosine) sum += cosineAlong(x, y, lit.corner) - cosineAlong(x, y, end.corner);
    };
    for (const Shadow& shadow : shadows) {
        addUpTo(shadow.first);
        if (shadow.last.cosine < lit.cosine) lit = shadow.last;
    }
    addUpTo(last);
    return sum / 2.0;
}

double stringsBetween(const Strand& from, const Strand& to) {
    const double crossed = glm::length(from.a - to.a) + glm::length(from.b - to.b);
    const double uncrossed = glm::length(from.b - to.a) + glm::length(from.a - to.b);
    return std::max(0.0, (crossed - uncrossed) / 2.0);
}

}  // namespace

double roundingOf(const SegmentIndex& index) {
    double most = 0.0;
    for (std::uint32_t i = 0; i < index.scene().segments.size(); ++i)
        most = std::max(most, index.originShift(i));
    return 2.0 * most;
}

double unoccludedExchange(const Strand& from, const Strand& to) {
    Strand seeing = from, seen = to;
    return faceEachOther(seeing, seen) ? stringsBetween(seeing, seen) : 0.0;
}

double exchangeLength(const Strand& from, const Strand& to, std::span<const Strand> walls, double rounding,
                      const StopQuestion& stop) {
    Strand seeing = from, seen = to;
    if (!faceEachOther(seeing, seen)) return 0.0;
    const std::vector<Blocker> blockers = blockersIn(Hull(seeing, seen, rounding), walls);
    if (blockers.empty()) return stringsBetween(seeing, seen);
    const std::vector<double> cuts = cutsOf(seeing, seen, blockers);
    std::vector<Shadow> shadows;
    const auto pointAt = [&](double u) { return u == 1.0 ? seeing.b : seeing.a + u * (seeing.b - seeing.a); };
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        throwIfStopped(stop, i);
        const Vec2 x = pointAt(cuts[i]), y = pointAt(cuts[i + 1]);
        if (x != y) sum += stretchExchange(x, y, seen, blockers, shadows);
    }
    return std::max(0.0, sum);
}

ExchangeLengths exchangeLengths(const SegmentIndex& index, const Patches& patches, const StopQuestion& stop) {
    const auto& segments = index.scene().segments;
    const std::vector<Patch>& all = patches.all();
    const double rounding = roundingOf(index);
    // Not zeroed at once: that alone takes many milliseconds of 4000 patches.
    ExchangeLengths lengths{all.size(), std::make_unique_for_overwrite<double[]>(all.size() * all.size())};
    for (std::size_t row = 0; row < all.size(); ++row) {
        throwIfStopped(stop, row);
        std::fill_n(lengths.all.get() + row * all.size(), all.size(), 0.0);
    }

    struct Side {
        Strand at;
        std::uint32_t segment;
        Patches::Range range;
    };
    std::vector<Side> sides;
    std::vector<Strand> walls, others;
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
        walls.push_back({segments[i].a, segments[i].b});
        sides.push_back({walls.back(), i, patches.of(i, true)});
        if (segments[i].twoSided) sides.push_back({{segments[i].b, segments[i].a}, i, patches.of(i, false)});
    }
    for (std::size_t one = 0; one < sides.size(); ++one)
        for (std::size_t two = 0; two < one; ++two) {
            throwIfStopped(stop, two);
            const Side &from = sides[one], &to = sides[two];
            Strand seeing = from.at, seen = to.at;
            if (from.segment == to.segment || !faceEachOther(seeing, seen)) continue;
            const Hull hull(seeing, seen, rounding);
            others.clear();
            for (std::uint32_t k = 0; k < walls.size(); ++k)
                if (k != from.segment && k != to.segment && hull.partOf(walls[k])) others.push_back(walls[k]);
            for (std::size_t i = from.range.first; i < from.range.end; ++i)
                for (std::size_t k = to.range.first; k < to.range.end; ++k) {
                    throwIfStopped(stop, k);
                    if (all[i].hidden || all[k].hidden) continue;
                    const double length =
                        exchangeLength({all[i].a, all[i].b}, {all[k].a, all[k].b}, others, rounding, stop);
                    lengths.all[i * all.size() + k] = lengths.all[k * all.size() + i] = length;
                }
        }
    return lengths;
}

}  // namespace halfdisk
