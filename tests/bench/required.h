// How fast has it to be? Ratios to Embree's rtcIntersect1 and rtcOccluded1 in the same run on one core.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace halfdisk {

/// What is asked, and how.
enum class Query : std::uint8_t { closest, closestBatch, any, anyBatch, fan };

struct QueryInfo {
    Query query;
    std::string_view id;
    std::string_view title;
    std::array<double, 7> ratios;  ///< for kSizes; 0: none required
};

inline constexpr std::array<std::size_t, 7> kSizes{16, 64, 256, 1'000, 10'000, 100'000, 1'000'000};

inline constexpr std::array<QueryInfo, 5> kQueries{{
    {Query::closest, "closest", "closest hit, one by one", {4.0, 2.5, 1.5, 1.4, 1.4, 1.4, 1.2}},
    {Query::closestBatch, "closest-batch", "closest hit, in batches", {0.0, 0.0, 1.5, 1.5, 1.6, 2.0, 3.0}},
    {Query::any, "any", "any hit between two points, one by one", {3.0, 2.2, 1.8, 1.6, 1.6, 1.5, 1.3}},
    {Query::anyBatch, "any-batch", "any hit between two points, in batches", {}},
    {Query::fan, "fan", "closest hit, half-disk fans as packets", {0.0, 0.0, 0.0, 4.0, 3.5, 3.0, 0.0}},
}};

/// Clustered scenes may lose a fifth.
inline constexpr double kClusteredShare = 0.8;
inline constexpr double kBox2DRatio = 4.0;
inline constexpr double kBuildShare = 0.6;      ///< of Embree's time, at most
inline constexpr double kBytesPerSegment = 32;  ///< at most
inline constexpr double kRebuildSeconds = 0.005;
inline constexpr double kSpeedupOnTwoCores = 1.9;
inline constexpr double kOverheadNanoseconds = 60.0;  ///< per ray of castRay beyond the index, at most
inline constexpr double kCancelMilliseconds = 20.0;
inline constexpr double kFrameMilliseconds = 8.0;
inline constexpr double kFirstMilliseconds = 50.0;
inline constexpr double kObserverRatio = 1.02;

inline std::optional<double> requiredRatio(const QueryInfo& query, std::size_t size, bool clustered) {
    for (std::size_t i = 0; i < kSizes.size(); ++i)
        if (kSizes[i] == size && query.ratios[i] > 0.0)
            return query.ratios[i] * (clustered ? kClusteredShare : 1.0);
    return std::nullopt;
}

}  // namespace halfdisk
