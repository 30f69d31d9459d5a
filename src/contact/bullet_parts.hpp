/// What the two halves of Bullet's face share: bullet_world.cpp, where balls meet balls, floor and
/// walls, and bullet_skin.cpp, where a ball asks for the triangles near it.
#ifndef BALLOON_CONTACT_BULLET_PARTS_HPP
#define BALLOON_CONTACT_BULLET_PARTS_HPP

#include <memory>
#include <vector>

// Bullet's headers must know which of its two builds is linked
#if defined(BALLOON_DOUBLE) && !defined(BT_USE_DOUBLE_PRECISION)
#define BT_USE_DOUBLE_PRECISION
#endif
#include <btBulletDynamicsCommon.h>
#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>

#include "contact/bullet.h"

static_assert(sizeof(btScalar) == sizeof(real), "Bullet's precision is the precision of the state");

/// Balls stay on the side that the normal points to: normal . x >= offset.
struct Wall {
    double4 normal;
    double offset; ///< [m]
    btStaticPlaneShape shape;
    btRigidBody body;

    Wall(double4 unit, double at);
};

struct Ball {
    btSphereShape shape;
    btRigidBody body;

    Ball(const Sphere& sphere, int number);
};

/// Bullet's dispatcher with our own meeting of balls and walls in place of its collision
/// algorithms, which wait for an overlap: a hit must count in the step in which it happens. It
/// starts anew at each step, in the order of the balls' numbers, so that no step depends on those
/// before it.
class Meetings : public btCollisionDispatcher {
  public:
    using btCollisionDispatcher::btCollisionDispatcher;

    const std::vector<std::unique_ptr<Ball>>* ball = nullptr;
    const std::vector<std::unique_ptr<Wall>>* wall = nullptr;
    const Sphere* sphere = nullptr; ///< the balls' own numbers, in full precision

    void dispatchAllCollisionPairs(btOverlappingPairCache* cache, const btDispatcherInfo& info,
                                   btDispatcher* self) override;

  private:
    std::vector<std::pair<int, int>> pair; ///< kept, so that a step allocates nothing

    void meet(int first, int second, double h);
};

struct Bullet {
    btDefaultCollisionConfiguration configuration;
    Meetings meetings;
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    std::vector<std::unique_ptr<Ball>> ball;
    std::vector<std::unique_ptr<Wall>> wall;
    btDiscreteDynamicsWorld world;

    Bullet();
    ~Bullet();
};

#endif
