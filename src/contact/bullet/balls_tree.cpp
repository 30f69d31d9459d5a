#include "contact/bullet/tree.hpp"

#include <algorithm>
#include <cmath>

#include "contact/bullet/trees.h"

namespace {

// Boxes larger by a few roundings of the coordinates miss no pair.
constexpr real ROUNDINGS = 4 * REAL_EPSILON;

/// Where a ball is between the times 0 and h, and the margin around it.
Box path_box(const Sphere& sphere, real h, real margin) {
    const real4 end = sphere.x + h * sphere.v;
    Box box;
    for (int k = 0; k < 4; k++) {
        const real low = std::min(sphere.x[k], end[k]), high = std::max(sphere.x[k], end[k]);
        const real far = std::max(std::fabs(low), std::fabs(high));
        const real around = sphere.radius + margin + ROUNDINGS * (far + sphere.radius + margin);
        box.low[k] = low - around;
        box.high[k] = high + around;
    }
    return box;
}

} // namespace

struct BulletBalls {
    btDbvt tree; ///< a leaf's data is its ball's number
    std::vector<btDbvtNode*> leaf;
    std::vector<int> hit;
    std::vector<int> pair; ///< of two numbers each

    void follow(const Sphere* sphere, int count, real h, real margin);
};

/// One leaf for each ball; the last come and go, so that a leaf's number is its ball's.
void BulletBalls::follow(const Sphere* sphere, int count, real h, real margin) {
    for (; (int)leaf.size() > count; leaf.pop_back())
        tree.remove(leaf.back());
    for (int i = 0; i < count; i++) {
        btDbvtVolume volume = volume_of(path_box(sphere[i], h, margin));
        if (i < (int)leaf.size())
            tree.update(leaf[(size_t)i], volume);
        else
            leaf.push_back(tree.insert(volume, leaf_number(i)));
    }
}

BulletBalls* bullet_balls_open(void) {
    return new BulletBalls;
}

void bullet_balls_close(BulletBalls* balls) {
    delete balls;
}

int bullet_balls_near(BulletBalls* balls, const Sphere* sphere, int count, double h, double margin,
                      const int (**pair)[2]) {
    balls->follow(sphere, count, (real)h, (real)margin);
    balls->pair.clear();
    for (int i = 0; i < count; i++) {
        Hits hits(&balls->hit);
        balls->tree.collideTV(balls->tree.m_root, balls->leaf[(size_t)i]->volume, hits);
        // the tree's order depends on earlier calls
        std::sort(balls->hit.begin(), balls->hit.end());
        for (const int other : balls->hit)
            if (other > i)
                balls->pair.insert(balls->pair.end(), {i, other});
    }
    *pair = reinterpret_cast<const int(*)[2]>(balls->pair.data());
    return (int)balls->pair.size() / 2;
}
