#include "contact/bullet/tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/bullet/trees.h"

namespace {

constexpr int PATCH = 64; // triangles

// A reach larger by this share, and by a few roundings of the coordinates, misses no triangle.
constexpr double SLACK = 1e-3;

constexpr real FAR = std::numeric_limits<real>::max();
constexpr Box NOTHING = {{FAR, FAR, FAR, 0}, {-FAR, -FAR, -FAR, 0}};

real4 lower(real4 a, real4 b) {
    return a < b ? a : b;
}

real4 higher(real4 a, real4 b) {
    return a > b ? a : b;
}

Box larger(const Box& box, real margin) {
    const real4 around = {margin, margin, margin, 0};
    return {box.low - around, box.high + around};
}

/// Whether two boxes are within reach of each other along each axis.
bool meet(const Box& a, const Box& b, real reach) {
    const real4 gap = higher(a.low - b.high, b.low - a.high);
    return gap[0] <= reach && gap[1] <= reach && gap[2] <= reach;
}

/// The pairs of leaves that a search meets.
struct LeafPairs : btDbvt::ICollide {
    explicit LeafPairs(std::vector<std::pair<int, int>>* pair_) : pair(pair_) {
    }

    void Process(const btDbvtNode* a, const btDbvtNode* b) {
        pair->emplace_back(a->dataAsInt, b->dataAsInt);
    }

  private:
    std::vector<std::pair<int, int>>* pair;
};

/// A reach that misses nothing by rounding.
real rounded_reach(double reach, double far) {
    return (real)(reach * (1 + SLACK) + 4 * REAL_EPSILON * (far + reach));
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

/// A point's number along Morton's curve through a box: near numbers are near points.
std::uint64_t morton(real4 point, const Box& box) {
    std::uint64_t code = 0;
    for (int k = 0; k < 3; k++) {
        const double size = (double)box.high[k] - (double)box.low[k];
        const double share = size > 0 ? ((double)point[k] - (double)box.low[k]) / size : 0;
        code |= spread((std::uint64_t)(std::clamp(share, 0.0, 1.0) * ((1 << 21) - 1))) << k;
    }
    return code;
}

} // namespace

/// A skin in patches of PATCH triangles that lie together, under a tree of Bullet's boxes.
struct BulletSkin {
    BulletSkin(const int (*triangle)[3], int triangle_count, const real4* x, int point_count);

    void refit(real margin);
    const std::vector<int>& near(real4 center, real reach);
    const std::vector<int>& near_triangles(const BulletSkin& other, real reach);

    Box whole = NOTHING;

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
    btDbvt tree;            ///< over the patches; a leaf's data is its patch's number
    std::vector<int> hit;   ///< patches that the last search looked into
    std::vector<int> found; ///< what it found
    std::vector<std::pair<int, Box>>
        nearby[2]; ///< of two patches, the triangles near the other's box

    void sort_along_curve(const int (*triangle)[3], int triangle_count, int point_count);
    void collect_particles();
    void refit_node(btDbvtNode* node, real margin);
    /// Box of triangle i of the patches' order; inlined into the searches' loops.
    Box box(int i) const {
        const int* point = corners[(size_t)i].point;
        const real4 a = x[point[0]], b = x[point[1]], c = x[point[2]];
        return {lower(lower(a, b), c), higher(higher(a, b), c)};
    }
    void collect_nearby(int patch, const Box& other, real reach,
                        std::vector<std::pair<int, Box>>* list) const;
    void search_patches(int patch, const BulletSkin& other, int other_patch, real reach);
    void search_patch(int patch, real4 center, real reach);
};

BulletSkin::BulletSkin(const int (*triangle)[3], int triangle_count, const real4* x_,
                       int point_count)
    : x(x_) {
    sort_along_curve(triangle, triangle_count, point_count);
    collect_particles();
    const int patches = (int)particle_from.size() - 1;
    patch_box.resize((size_t)patches);
    for (int p = 0; p < patches; p++)
        tree.insert(volume_of(Box{x[0], x[0]}), leaf_number(p));
    refit(0);
    tree.optimizeTopDown();
}

void BulletSkin::sort_along_curve(const int (*triangle)[3], int triangle_count, int point_count) {
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

void BulletSkin::collect_particles() {
    particle_from.push_back(0);
    for (size_t from = 0; from < corners.size(); from += PATCH) {
        const size_t start = particle.size(), end = std::min(from + PATCH, corners.size());
        for (size_t i = from; i < end; i++)
            particle.insert(particle.end(), corners[i].point, corners[i].point + 3);
        std::sort(particle.begin() + (long)start, particle.end());
        particle.erase(std::unique(particle.begin() + (long)start, particle.end()), particle.end());
        particle_from.push_back((int)particle.size());
    }
}

/// The tree keeps its shape, for patches that lie together at first stay together.
void BulletSkin::refit_node(btDbvtNode* node, real margin) {
    if (node->isleaf()) {
        node->volume = volume_of(larger(patch_box[(size_t)node->dataAsInt], margin));
        return;
    }
    refit_node(node->childs[0], margin);
    refit_node(node->childs[1], margin);
    Merge(node->childs[0]->volume, node->childs[1]->volume, node->volume);
}

void BulletSkin::refit(real margin) {
    whole = NOTHING;
    for (size_t p = 0; p < patch_box.size(); p++) {
        const Box box =
            box_of(x, &particle[particle_from[p]], particle_from[p + 1] - particle_from[p]);
        patch_box[p] = box;
        whole = {lower(whole.low, box.low), higher(whole.high, box.high)};
    }
    refit_node(tree.m_root, margin);
}

void BulletSkin::search_patch(int patch, real4 center, real reach) {
    const size_t end = std::min((size_t)(patch + 1) * PATCH, corners.size());
    for (size_t i = (size_t)patch * PATCH; i < end; i++)
        if (within(box((int)i), center, reach))
            found.push_back(corners[i].number);
}

/// Numbers of the triangles whose boxes are within reach, in rising order.
const std::vector<int>& BulletSkin::near(real4 center, real reach) {
    found.clear();
    Hits hits(&hit);
    const real4 around = {reach, reach, reach, 0};
    tree.collideTV(tree.m_root, volume_of({center - around, center + around}), hits);
    for (const int p : hit)
        if (within(patch_box[(size_t)p], center, reach))
            search_patch(p, center, reach);
    std::sort(found.begin(), found.end());
    return found;
}

/// The triangles of a patch that are within reach of a box.
void BulletSkin::collect_nearby(int patch, const Box& other, real reach,
                                std::vector<std::pair<int, Box>>* list) const {
    list->clear();
    const int end = std::min((patch + 1) * PATCH, (int)corners.size());
    for (int i = patch * PATCH; i < end; i++) {
        const Box here = box(i);
        if (meet(here, other, reach))
            list->emplace_back(i, here);
    }
}

void BulletSkin::search_patches(int patch, const BulletSkin& other, int other_patch, real reach) {
    collect_nearby(patch, other.patch_box[(size_t)other_patch], reach, &nearby[0]);
    other.collect_nearby(other_patch, patch_box[(size_t)patch], reach, &nearby[1]);
    const bool same = &other == this && patch == other_patch;
    for (const auto& [i, around] : nearby[0])
        for (const auto& [j, box] : nearby[1])
            if ((!same || i < j) && meet(around, box, reach))
                found.insert(found.end(),
                             {corners[(size_t)i].number, other.corners[(size_t)j].number});
}

const std::vector<int>& BulletSkin::near_triangles(const BulletSkin& other, real reach) {
    found.clear();
    std::vector<std::pair<int, int>> patches;
    LeafPairs pairs(&patches);
    tree.collideTT(tree.m_root, other.tree.m_root, pairs);
    if (&other == this)
        for (int p = 0; p < (int)patch_box.size(); p++)
            patches.emplace_back(p, p);
    for (const auto& [a, b] : patches)
        search_patches(a, other, b, reach);
    return found;
}

BulletSkin* bullet_skin_open(const int (*triangle)[3], int triangle_count, const real4* x,
                             int point_count) {
    return new BulletSkin(triangle, triangle_count, x, point_count);
}

void bullet_skin_close(BulletSkin* skin) {
    delete skin;
}

void bullet_skin_refit(BulletSkin* skin, double margin) {
    skin->refit((real)margin);
}

void bullet_skin_box(const BulletSkin* skin, double low[3], double high[3]) {
    for (int k = 0; k < 3; k++) {
        low[k] = (double)skin->whole.low[k];
        high[k] = (double)skin->whole.high[k];
    }
}

int bullet_skin_near(BulletSkin* skin, const double center[3], double reach, int* triangle,
                     int capacity) {
    const double far = std::max({std::fabs(center[0]), std::fabs(center[1]), std::fabs(center[2])});
    const real4 at = {(real)center[0], (real)center[1], (real)center[2], 0};
    const std::vector<int>& found = skin->near(at, rounded_reach(reach, far));
    std::copy_n(found.begin(), std::min((int)found.size(), capacity), triangle);
    return (int)found.size();
}

int bullet_skin_near_triangles(BulletSkin* skin, const BulletSkin* other, double reach,
                               const int (**pair)[2]) {
    double far = 0;
    for (const BulletSkin* s : {(const BulletSkin*)skin, other})
        for (int k = 0; k < 3; k++)
            far = std::max(
                {far, std::fabs((double)s->whole.low[k]), std::fabs((double)s->whole.high[k])});
    const std::vector<int>& found = skin->near_triangles(*other, rounded_reach(reach, far));
    *pair = reinterpret_cast<const int(*)[2]>(found.data());
    return (int)found.size() / 2;
}
