// How is Embree asked? Segments stand upright as triangles, rays run in the plane z = 0.
#include <embree3/rtcore.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "peers.h"
#include "timing.h"

namespace halfdisk {
namespace {

// How far oneTriangle's upper side lies above z = 0, the tip being one below.
constexpr double kAbove = 1.0 / 64.0;

void setVertex(float* vertices, std::size_t i, Vec2 p, double z) {
    vertices[3 * i] = static_cast<float>(p.x);
    vertices[3 * i + 1] = static_cast<float>(p.y);
    vertices[3 * i + 2] = static_cast<float>(z);
}

class Embree final : public Peer {
 public:
    Embree(const Scene& scene, Extrusion extrusion)
        : trianglesPerSegment_(extrusion == Extrusion::twoTriangles ? 2 : 1) {
        device_.reset(rtcNewDevice("threads=1"));
        if (!device_) throw std::runtime_error("Embree gives no device");
        rtcSetDeviceMemoryMonitorFunction(
            device_.get(),
            [](void* bytes, ssize_t change, bool) {
                *static_cast<double*>(bytes) += static_cast<double>(change);
                return true;
            },
            &allocated_);
        scene_.reset(rtcNewScene(device_.get()));
        rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_MEDIUM);
        const Geometry geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
        rtcSetGeometryBuildQuality(geometry.get(), RTC_BUILD_QUALITY_MEDIUM);
        fill(geometry.get(), scene, extrusion);
        const double before = allocated_, start = processSeconds();
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometry(scene_.get(), geometry.get());
        rtcCommitScene(scene_.get());
        buildSeconds_ = processSeconds() - start;
        bytes_ = allocated_ - before;
        if (const RTCError error = rtcGetDeviceError(device_.get()); error != RTC_ERROR_NONE)
            throw std::runtime_error("Embree fails with error " + std::to_string(error));
    }

    void closest(std::span<const FloatRay> rays, std::span<PeerHit> hits) const override {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            RTCRayHit both;
            both.ray = rayOf(rays[i]);
            both.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            both.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(scene_.get(), &context, &both);
            hits[i] = hitOf(both.hit.geomID, both.hit.primID, both.ray.tfar);
        }
    }

    void occluded(std::span<const FloatRay> rays, std::span<std::uint8_t> answers) const override {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            RTCRay ray = rayOf(rays[i]);
            rtcOccluded1(scene_.get(), &context, &ray);
            answers[i] = ray.tfar < 0.0f;
        }
    }

    void closestPackets(std::span<const FloatRay> rays, std::span<PeerHit> hits) const override {
        constexpr std::size_t kWidth = 16;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        alignas(64) int valid[kWidth];
        std::fill(std::begin(valid), std::end(valid), -1);
        for (std::size_t first = 0; first < rays.size(); first += kWidth) {
            RTCRayHit16 packet;
            for (std::size_t k = 0; k < kWidth; ++k) {
                const RTCRay ray = rayOf(rays[first + k]);
                packet.ray.org_x[k] = ray.org_x;
                packet.ray.org_y[k] = ray.org_y;
                packet.ray.org_z[k] = ray.org_z;
                packet.ray.tnear[k] = ray.tnear;
                packet.ray.dir_x[k] = ray.dir_x;
                packet.ray.dir_y[k] = ray.dir_y;
                packet.ray.dir_z[k] = ray.dir_z;
                packet.ray.time[k] = ray.time;
                packet.ray.tfar[k] = ray.tfar;
                packet.ray.mask[k] = ray.mask;
                packet.ray.id[k] = ray.id;
                packet.ray.flags[k] = ray.flags;
                packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
                packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
            }
            rtcIntersect16(valid, scene_.get(), &context, &packet);
            for (std::size_t k = 0; k < kWidth; ++k)
                hits[first + k] = hitOf(packet.hit.geomID[k], packet.hit.primID[k], packet.ray.tfar[k]);
        }
    }

    double buildSeconds() const override { return buildSeconds_; }
    double bytes() const override { return bytes_; }

 private:
    struct Release {
        void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
        void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
        void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
    };
    template <class Handle>
    using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Release>;
    using Geometry = Owned<RTCGeometry>;

    static void fill(RTCGeometry geometry, const Scene& scene, Extrusion extrusion) {
        const bool two = extrusion == Extrusion::twoTriangles;
        const std::size_t count = scene.segments.size(), corners = two ? 4 : 3, triangles = two ? 2 : 1;
        auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), count * corners));
        auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), count * triangles));
        if (!vertices || !indices) throw std::bad_alloc();
        for (std::size_t i = 0; i < count; ++i) {
            const auto [a, b] = std::pair{scene.segments[i].a, scene.segments[i].b};
            const std::size_t first = i * corners;
            setVertex(vertices, first, a, -1.0);
            if (two) {
                setVertex(vertices, first + 1, b, -1.0);
                setVertex(vertices, first + 2, b, 1.0);
                setVertex(vertices, first + 3, a, 1.0);
            } else {
                setVertex(vertices, first + 1, a, kAbove);
                setVertex(vertices, first + 2, a + (1.0 + kAbove) * (b - a), kAbove);
            }
            for (std::size_t t = 0; t < triangles; ++t) {
                *indices++ = static_cast<unsigned>(first);
                *indices++ = static_cast<unsigned>(first + t + 1);
                *indices++ = static_cast<unsigned>(first + t + 2);
            }
        }
    }

    static RTCRay rayOf(const FloatRay& ray) {
        return {ray.x, ray.y, 0.0f, 0.0f, ray.dx, ray.dy, 0.0f, 0.0f, ray.tMax, 0xFFFFFFFFu, 0, 0};
    }

    PeerHit hitOf(unsigned geometry, unsigned triangle, float t) const {
        if (geometry == RTC_INVALID_GEOMETRY_ID) return {kNoSegment, t};
        return {triangle / trianglesPerSegment_, t};
    }

    unsigned trianglesPerSegment_;
    double allocated_ = 0.0, bytes_ = 0.0, buildSeconds_ = 0.0;
    Owned<RTCDevice> device_;
    Owned<RTCScene> scene_;
};

}  // namespace

std::unique_ptr<Peer> makeEmbree(const Scene& scene, Extrusion extrusion) {
    return std::make_unique<Embree>(scene, extrusion);
}

}  // namespace halfdisk
