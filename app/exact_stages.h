// What is exactly known about the light at P and about the pictures? Computed behind the frame, and kept
// while the scene stays.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "app/light_answer.h"
#include "core/exact_field.h"
#include "core/reference.h"

namespace halfdisk {

/// An exact picture that was computed.
struct KnownPicture {
    Sensor sensor;
    unsigned depth = 0;
    std::shared_ptr<const std::vector<Rgb>> pixels;
};

/// The same of a field's cells; without a depth light of all bounces.
struct KnownField {
    std::optional<unsigned> depth;
    std::shared_ptr<const KnownCells> cells;
};

/// The reference of the scene asked about last: kept, since it takes longer than all else and does not depend
/// on P. So are the last pictures.
struct ReferenceCache {
    std::shared_ptr<const PreparedScene> scene;
    unsigned depth = 0;
    std::unique_ptr<Reference> reference;
    std::vector<KnownPicture> pictures;
    std::vector<KnownField> fields;
};

/// E at P, and what arrives there from every direction; nothing where the scene has no exact answer.
void findExact(LightAnswer& answer, ReferenceCache& cache, const std::atomic<bool>& cancelled);

/// What the eye's strip and the wall's profile should be, for both makers; only if the question wants to see
/// differences, or compares. What some of the field's cells should be only if it compares.
void findExactPictures(LightAnswer& answer, ReferenceCache& cache, const std::atomic<bool>& cancelled);

/// How far a picture is from the exact one, as a share of it; nothing if that is not known.
std::optional<double> errorOf(const LightAnswer& answer, View view, std::size_t side);

}  // namespace halfdisk
