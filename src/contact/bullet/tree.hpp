/// Bullet's dynamic tree of boxes, as the balls and the patches of a skin stand in it.
#ifndef BALLOON_CONTACT_BULLET_TREE_HPP
#define BALLOON_CONTACT_BULLET_TREE_HPP

#include <cstdint>
#include <vector>

// Bullet's headers must know which of its two builds is linked
#if defined(BALLOON_DOUBLE) && !defined(BT_USE_DOUBLE_PRECISION)
#define BT_USE_DOUBLE_PRECISION
#endif
#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include "base/vec.h"

static_assert(sizeof(btScalar) == sizeof(real), "Bullet's precision is the precision of the state");

struct Box {
    real4 low;
    real4 high;
};

inline btDbvtVolume volume_of(const Box& box) {
    return btDbvtVolume::FromMM(btVector3(box.low[0], box.low[1], box.low[2]),
                                btVector3(box.high[0], box.high[1], box.high[2]));
}

inline void* leaf_number(int number) {
    return reinterpret_cast<void*>((std::intptr_t)number);
}

/// The numbers of the leaves that a search meets.
struct Hits : btDbvt::ICollide {
    explicit Hits(std::vector<int>* number_) : number(number_) {
        number->clear();
    }

    void Process(const btDbvtNode* leaf) {
        number->push_back(leaf->dataAsInt);
    }

  private:
    std::vector<int>* number;
};

#endif
