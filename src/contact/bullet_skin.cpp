#include "contact/bullet_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace {

constexpr int PATCH = 64; // triangles

// Bullet's test of a triangle rounds; a reach larger by this share, and by a few roundings of the
// place itself, misses none.
constexpr double SLACK = 1e-3;

// How far Bullet's normal of a triangle may be off, in roundings of edge^2 over twice the area.
constexpr real NORMAL_ROUNDINGS = 8;

struct Box {
    real4 low;
    real4 high;
};

constexpr real FAR = std::numeric_limits<real>::max();
constexpr Box NOTHING = {{FAR, FAR, FAR, 0}, {-FAR, -FAR, -FAR, 0}};

real4 lower(real4 a, real4 b) {
    return a < b ? a : b;
}

real4 higher(real4 a, real4 b) {
    return a > b ? a : b;
}

/// Whether some of a box is within reach of a point.
bool within(const Box& box, real4 point, real reach) {
    const real4 nothing = {0, 0, 0, 0};
    const real4 away = higher(higher(box.low - point, point - box.high), nothing);
    return dot(away, away) <= reach * reach;
}

/// The box of some of the particles: the one hot loop of a refit. In the 16 bytes that every
/// machine has, because a comparison of four doubles is taken apart where it has no more.
Box box_of(const real4* x, const int* particle, int count) {
    typedef real Piece __attribute__((vector_size(16), may_alias));
    constexpr int PIECES = sizeof(real4) / sizeof(Piece);
    Box box = NOTHING;
    Piece* low = reinterpret_cast<Piece*>(&box.low);
    Piece* high = reinterpret_cast<Piece*>(&box.high);
    for (int i = 0; i < count; i++) {
        const Piece* at = reinterpret_cast<const Piece*>(&x[particle[i]]);
        for (int k = 0; k < PIECES; k++) {
            low[k] = at[k] < low[k] ? at[k] : low[k];
            high[k] = at[k] > high[k] ? at[k] : high[k];
        }
    }
    return box;
}

/// The bits of a number below 2^21, each followed by two zeros.
std::uint64_t spread(std::uint64_t a) {
    std::uint64_t code = 0;
    for (int bit = 0; bit < 21; bit++)
        code |= (a >> bit & 1) << (3 * bit);
    return code;
}

/// A place's number along Morton's curve through a box, on which near numbers are near places.
std::uint64_t morton(real4 place, const Box& box) {
    std::uint64_t code = 0;
    for (int k = 0; k < 3; k++) {
        const double size = (double)box.high[k] - (double)box.low[k];
        const double share = size > 0 ? ((double)place[k] - (double)box.low[k]) / size : 0;
        code |= spread((std::uint64_t)(std::clamp(share, 0.0, 1.0) * ((1 << 21) - 1))) << k;
    }
    return code;
}

} // namespace

/// The skin as Bullet sees it: it is asked for the triangles in a box.
class Patches : public btConcaveShape {
  public:
    Patches(const int (*triangle)[3], int triangle_count, const real4* x, int point_count);

    void refit(real margin);
    const Box& box() const {
        return whole;
    }

    /// The question that is being asked, and who gets the triangles that Bullet cannot measure.
    real4 center = {0, 0, 0, 0};
    real reach = 0;
    std::vector<int>* unmeasured = nullptr;

    void processAllTriangles(btTriangleCallback* callback, const btVector3& low,
                             const btVector3& high) const override;

    void getAabb(const btTransform& /*place*/, btVector3& low, btVector3& high) const override {
        low.setValue(whole.low[0], whole.low[1], whole.low[2]);
        high.setValue(whole.high[0], whole.high[1], whole.high[2]);
    }
    void setLocalScaling(const btVector3& /*scaling*/) override {
    }
    const btVector3& getLocalScaling() const override {
        return scaling;
    }
    void calculateLocalInertia(btScalar /*mass*/, btVector3& inertia) const override {
        inertia.setZero();
    }
    const char* getName() const override {
        return "Patches";
    }

  private:
    struct Corners {
        int number; ///< the triangle's own
        int point[3];
    };

    const real4* x;
    std::vector<Corners> corners;   ///< patch by patch
    std::vector<int> particle;      ///< of each patch, each once
    std::vector<int> particle_from; ///< [patches + 1]
    std::vector<Box> patch_box;
    Box whole = NOTHING;
    btVector3 scaling{1, 1, 1};

    void sort_by_place(const int (*triangle)[3], int triangle_count, int point_count);
    bool measurable(const real4 corner[3]) const;
    void process(const Corners& each, btTriangleCallback* callback) const;
};

struct BulletSkin {
    Patches patches;
    btCollisionObject object;

    BulletSkin(const int (*triangle)[3], int triangle_count, const real4* x, int point_count)
        : patches(triangle, triangle_count, x, point_count) {
        object.setCollisionShape(&patches);
    }
};

Patches::Patches(const int (*triangle)[3], int triangle_count, const real4* x_, int point_count)
    : x(x_) {
    // this version's own type for custom shapes is taken by another shape
    m_shapeType = FAST_CONCAVE_MESH_PROXYTYPE;
    setMargin(0);

    sort_by_place(triangle, triangle_count, point_count);
    particle_from.push_back(0);
    for (size_t from = 0; from < corners.size(); from += PATCH) {
        const size_t start = particle.size(), end = std::min(from + PATCH, corners.size());
        for (size_t i = from; i < end; i++)
            particle.insert(particle.end(), corners[i].point, corners[i].point + 3);
        std::sort(particle.begin() + (long)start, particle.end());
        particle.erase(std::unique(particle.begin() + (long)start, particle.end()), particle.end());
        particle_from.push_back((int)particle.size());
    }
    patch_box.resize(particle_from.size() - 1);
    refit(0);
}

void Patches::sort_by_place(const int (*triangle)[3], int triangle_count, int point_count) {
    Box box = NOTHING;
    for (int i = 0; i < point_count; i++) {
        box.low = lower(box.low, x[i]);
        box.high = higher(box.high, x[i]);
    }
    std::vector<std::pair<std::uint64_t, int>> order;
    for (int t = 0; t < triangle_count; t++) {
        const real4 sum = x[triangle[t][0]] + x[triangle[t][1]] + x[triangle[t][2]];
        order.emplace_back(morton(sum / 3, box), t);
    }
    std::sort(order.begin(), order.end());
    for (const auto& [code, t] : order)
        corners.push_back({t, {triangle[t][0], triangle[t][1], triangle[t][2]}});
}

void Patches::refit(real margin) {
    const real4 grown = {margin, margin, margin, 0};
    whole = NOTHING;
    for (size_t p = 0; p < patch_box.size(); p++) {
        Box box = box_of(x, &particle[particle_from[p]], particle_from[p + 1] - particle_from[p]);
        box = {box.low - grown, box.high + grown};
        patch_box[p] = box;
        whole = {lower(whole.low, box.low), higher(whole.high, box.high)};
    }
}

/// Bullet drops triangles of almost no area, and the thinner or larger a triangle, the worse it
/// knows the plane's distance. True if the error stays below the slack in reach.
bool Patches::measurable(const real4 corner[3]) const {
    const real4 a = corner[1] - corner[0], b = corner[2] - corner[0];
    const real edge2 = real_max(real_max(dot(a, a), dot(b, b)), dot(b - a, b - a));
    const real area = length(cross(a, b));
    const real size = real_sqrt(edge2) + reach;
    return area > 2 * SIMD_EPSILON &&
           NORMAL_ROUNDINGS * REAL_EPSILON * edge2 * size < (real)(SLACK / 2) * reach * area;
}

void Patches::process(const Corners& each, btTriangleCallback* callback) const {
    const real4 corner[3] = {x[each.point[0]], x[each.point[1]], x[each.point[2]]};
    const Box box = {lower(lower(corner[0], corner[1]), corner[2]),
                     higher(higher(corner[0], corner[1]), corner[2])};
    if (!within(box, center, reach))
        return;
    if (!measurable(corner)) {
        unmeasured->push_back(each.number);
        return;
    }
    btVector3 vertex[3];
    for (int k = 0; k < 3; k++)
        vertex[k].setValue(corner[k][0], corner[k][1], corner[k][2]);
    callback->processTriangle(vertex, 0, each.number);
}

void Patches::processAllTriangles(btTriangleCallback* callback, const btVector3& /*low*/,
                                  const btVector3& /*high*/) const {
    // Bullet asks for the ball's box; the ball is less than that
    for (size_t p = 0; p < patch_box.size(); p++) {
        if (!within(patch_box[p], center, reach))
            continue;
        const size_t end = std::min((p + 1) * PATCH, corners.size());
        for (size_t i = p * PATCH; i < end; i++)
            process(corners[i], callback);
    }
}

namespace {

struct Collect : btCollisionWorld::ContactResultCallback {
    std::vector<int>* found;

    explicit Collect(std::vector<int>* into) : found(into) {
    }

    btScalar addSingleResult(btManifoldPoint& /*point*/, const btCollisionObjectWrapper* /*a*/,
                             int /*part_a*/, int index_a, const btCollisionObjectWrapper* /*b*/,
                             int /*part_b*/, int index_b) override {
        // the ball's own index is -1
        found->push_back(std::max(index_a, index_b));
        return 0;
    }
};

} // namespace

BulletSkin* bullet_skin_open(Bullet* /*bullet*/, const int (*triangle)[3], int triangle_count,
                             const real4* x, int point_count) {
    return new BulletSkin(triangle, triangle_count, x, point_count);
}

void bullet_skin_close(Bullet* /*bullet*/, BulletSkin* skin) {
    delete skin;
}

void bullet_skin_refit(BulletSkin* skin, double margin) {
    skin->patches.refit((real)margin);
}

void bullet_skin_box(const BulletSkin* skin, double low[3], double high[3]) {
    for (int k = 0; k < 3; k++) {
        low[k] = (double)skin->patches.box().low[k];
        high[k] = (double)skin->patches.box().high[k];
    }
}

int bullet_skin_near(Bullet* bullet, BulletSkin* skin, const double center[3], double reach,
                     int* triangle, int room) {
    const double far = std::max({std::fabs(center[0]), std::fabs(center[1]), std::fabs(center[2])});
    const real asked = (real)(reach * (1 + SLACK) + 4 * REAL_EPSILON * (far + reach));
    const btVector3 place((btScalar)center[0], (btScalar)center[1], (btScalar)center[2]);
    const real4 at = {place.x(), place.y(), place.z(), 0};
    if (!within(skin->patches.box(), at, asked))
        return 0;

    bullet->found.clear();
    skin->patches.center = at;
    skin->patches.reach = asked;
    skin->patches.unmeasured = &bullet->found;
    bullet->probe_shape.setUnscaledRadius(asked);
    bullet->probe.setWorldTransform(btTransform(btMatrix3x3::getIdentity(), place));
    Collect collect(&bullet->found);
    bullet->world.contactPairTest(&bullet->probe, &skin->object, collect);

    std::vector<int>& found = bullet->found;
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::copy_n(found.begin(), std::min((int)found.size(), room), triangle);
    return (int)found.size();
}
