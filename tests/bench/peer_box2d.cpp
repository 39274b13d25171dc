// How is Box2D asked? Segments are the static edges of one body.
#include <box2d/box2d.h>

#include <cmath>

#include "peers.h"
#include "timing.h"

namespace halfdisk {
namespace {

// Box2D takes what is shorter than 5 mm for nothing.
constexpr float kScale = 1000.0f;
// A way longer than any in the unit box stands for one without end.
constexpr float kFar = 1.5f;

b2Vec2 scaled(double x, double y) {
    return {kScale * static_cast<float>(x), kScale * static_cast<float>(y)};
}

struct Closest final : b2RayCastCallback {
    PeerHit hit{kNoSegment, kFar};
    float ReportFixture(b2Fixture* fixture, const b2Vec2&, const b2Vec2&, float fraction) override {
        hit = {static_cast<std::uint32_t>(fixture->GetUserData().pointer), fraction};
        return fraction;
    }
};

struct Any final : b2RayCastCallback {
    bool met = false;
    float ReportFixture(b2Fixture*, const b2Vec2&, const b2Vec2&, float) override {
        met = true;
        return 0.0f;
    }
};

class Box2D final : public Peer {
 public:
    explicit Box2D(const Scene& scene) : world_(b2Vec2(0.0f, 0.0f)) {
        const double start = processSeconds();
        const b2BodyDef standing;
        b2Body* body = world_.CreateBody(&standing);
        for (std::size_t i = 0; i < scene.segments.size(); ++i) {
            const Segment& segment = scene.segments[i];
            b2EdgeShape edge;
            edge.SetTwoSided(scaled(segment.a.x, segment.a.y), scaled(segment.b.x, segment.b.y));
            b2FixtureDef fixture;
            fixture.shape = &edge;
            fixture.userData.pointer = i;
            body->CreateFixture(&fixture);
        }
        buildSeconds_ = processSeconds() - start;
    }

    void closest(std::span<const FloatRay> rays, std::span<PeerHit> hits) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            Closest closest;
            const float way = cast(rays[i], closest);
            hits[i] = {closest.hit.segment, closest.hit.t * way};
        }
    }

    void occluded(std::span<const FloatRay> rays, std::span<std::uint8_t> answers) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            Any any;
            cast(rays[i], any);
            answers[i] = any.met;
        }
    }

    double buildSeconds() const override { return buildSeconds_; }

 private:
    /// Returns how long the way was.
    float cast(const FloatRay& ray, b2RayCastCallback& callback) const {
        const float way = std::min(ray.tMax, kFar);
        world_.RayCast(&callback, scaled(ray.x, ray.y), scaled(ray.x + way * ray.dx, ray.y + way * ray.dy));
        return way;
    }

    b2World world_;
    double buildSeconds_ = 0.0;
};

}  // namespace

std::unique_ptr<Peer> makeBox2D(const Scene& scene) {
    return std::make_unique<Box2D>(scene);
}

}  // namespace halfdisk
