#include "contact/bullet_parts.hpp"

#include <algorithm>
#include <cmath>

namespace {

// A pair this near, as a share of the smaller radius, is taken as touching.
constexpr double TOUCHING = 0.01;

// A ball at rest falls g h in a step and must not bounce from that; twice the Earth's [m/s^2].
constexpr double RESTING = 20;

// Balls that overlap part at their depth times the rate [1/s], but by no more than the share of the
// depth in a step, and no faster than so many radii a second: whoever puts a ball inside another
// sees it come out, not shot out.
constexpr double PARTING_RATE = 10;
constexpr double PARTING_SHARE = 0.2;
constexpr double PARTING_RADII = 2;

// Sequential impulses converge slowly where a light ball carries a heavy one.
constexpr int ROUNDS = 50;

/// Where two meet within the step, seen from the first.
struct Meeting {
    double4 normal; ///< from the second to the first, at the time of the meeting
    double gap; ///< what is left between them along the normal now, negative if they overlap [m]
    double closing; ///< speed along the normal, towards each other [m/s]
    double at[2];   ///< from each centre to the common point, along the normal [m]
    double radius;  ///< the smaller one's [m]
};

btVector3 bullet_vector(real4 a) {
    return btVector3(a[0], a[1], a[2]);
}

real4 our_vector(const btVector3& a) {
    return real4{a.x(), a.y(), a.z(), 0};
}

double square(double a) {
    return a * a;
}

/// The time until |d + t v| = reach, for |d| > reach; beyond the step if never.
double time_to_touch(double4 d, double4 v, double reach) {
    const double towards = -ddot(d, v);
    const double speed2 = ddot(v, v);
    const double root2 = square(towards) - speed2 * (ddot(d, d) - square(reach));
    if (towards <= 0 || root2 < 0)
        return INFINITY;
    return (ddot(d, d) - square(reach)) / (towards + std::sqrt(root2));
}

bool balls_meet(const Sphere& a, const Sphere& b, double h, Meeting* meeting) {
    const double4 d = to_double4(a.x) - to_double4(b.x);
    const double4 v = to_double4(a.v) - to_double4(b.v);
    const double reach = (double)a.radius + (double)b.radius;
    const double radius = std::min(a.radius, b.radius);
    const double distance = dlength(d), gap = distance - reach;

    // touching: at the point between them, so that the pair's angular momentum is kept
    if (gap <= TOUCHING * radius) {
        const double4 n = distance > 0 ? d / distance : double4{0, 1, 0, 0};
        *meeting = {n, gap, -ddot(n, v), {a.radius + gap / 2, b.radius + gap / 2}, radius};
        return true;
    }

    // apart: where their straight paths make them touch
    const double t = time_to_touch(d, v, reach);
    if (!(t <= h))
        return false;
    const double4 n = (d + t * v) / reach;
    *meeting = {n, -ddot(n, v) * t, -ddot(n, v), {a.radius, b.radius}, radius};
    return true;
}

bool wall_met(const Sphere& a, const Wall& wall, double h, Meeting* meeting) {
    const double gap = ddot(wall.normal, to_double4(a.x)) - wall.offset - a.radius;
    const double closing = -ddot(wall.normal, to_double4(a.v));
    *meeting = {wall.normal, gap, closing, {a.radius, 0}, a.radius};
    return gap <= std::max(TOUCHING * a.radius, closing * h);
}

/// The least speed at which the two must part: back from a hit by its restitution, gently out of an
/// overlap, and otherwise just so that they arrive at each other at the end of the step.
double least_parting(const Meeting& meeting, double restitution, double h) {
    double least = -meeting.gap / h;
    if (meeting.gap < 0)
        least = std::min({PARTING_SHARE / h * -meeting.gap, PARTING_RATE * -meeting.gap,
                          PARTING_RADII * meeting.radius});
    if (meeting.closing * h >= meeting.gap && meeting.closing > RESTING * h)
        least = std::max(least, restitution * meeting.closing);
    return least;
}

btRigidBody::btRigidBodyConstructionInfo body_of(double mass, btCollisionShape* shape) {
    return btRigidBody::btRigidBodyConstructionInfo((btScalar)mass, nullptr, shape);
}

void copy_in(Ball& ball, const Sphere& sphere) {
    // its box must hold all that may count as touching
    ball.shape.setUnscaledRadius((btScalar)(1 + TOUCHING) * sphere.radius);
    const btScalar inertia = sphere_inertia(&sphere);
    ball.body.setMassProps(sphere.mass, btVector3(inertia, inertia, inertia));
    const btTransform at(btMatrix3x3::getIdentity(), bullet_vector(sphere.x));
    ball.body.setCenterOfMassTransform(at); // also turns the inertia into the world's frame
    ball.body.setLinearVelocity(bullet_vector(sphere.v));
    ball.body.setAngularVelocity(bullet_vector(sphere.spin));
    ball.body.forceActivationState(DISABLE_DEACTIVATION); // also one that Bullet lost as too fast
}

void copy_out(const Ball& ball, Sphere* sphere) {
    sphere->v = our_vector(ball.body.getLinearVelocity());
    sphere->spin = our_vector(ball.body.getAngularVelocity());
}

/// As many bodies as balls; the last come and go, so that a body's number is its ball's.
void bodies_follow(Bullet* bullet, const Sphere* sphere, int count) {
    while ((int)bullet->ball.size() > count) {
        bullet->world.removeRigidBody(&bullet->ball.back()->body);
        bullet->ball.pop_back();
    }
    for (int i = (int)bullet->ball.size(); i < count; i++) {
        bullet->ball.push_back(std::make_unique<Ball>(sphere[i], i));
        bullet->world.addRigidBody(&bullet->ball.back()->body);
    }
}

} // namespace

Wall::Wall(double4 unit, double at)
    : normal(unit), offset(at), shape(bullet_vector(to_real4(unit)), (btScalar)at),
      body(body_of(0, &shape)) {
}

Ball::Ball(const Sphere& sphere, int number)
    : shape(sphere.radius), body(body_of(sphere.mass, &shape)) {
    body.setUserIndex(number);
    body.setDamping(0, 0);
    body.setFlags(0); // a ball needs no gyroscopic torque
}

/// One contact point; Bullet is told the least parting speed as if it were a gap of `-speed h`,
/// which with its error reduction of 1 is the speed that it solves for.
void Meetings::meet(int first, int second, double h) {
    const int count = (int)ball->size();
    const Sphere& a = sphere[first];
    const bool is_ball = second < count;
    Meeting meeting;
    if (!(is_ball ? balls_meet(a, sphere[second], h, &meeting)
                  : wall_met(a, *(*wall)[second - count], h, &meeting)))
        return;
    btRigidBody& one = (*ball)[first]->body;
    btRigidBody& other = is_ball ? (*ball)[second]->body : (*wall)[second - count]->body;

    // what two balls share is the geometric mean, so that equal balls have their own numbers
    real restitution = a.restitution, friction = a.friction;
    if (is_ball) {
        restitution = real_sqrt(restitution * sphere[second].restitution);
        friction = real_sqrt(friction * sphere[second].friction);
    }

    const btVector3 n = bullet_vector(to_real4(meeting.normal));
    const double least = least_parting(meeting, restitution, h);
    btManifoldPoint point(btVector3(0, 0, 0), btVector3(0, 0, 0), n, (btScalar)(-least * h));
    point.m_positionWorldOnA = bullet_vector(a.x) - n * (btScalar)meeting.at[0];
    point.m_positionWorldOnB = other.getCenterOfMassPosition() + n * (btScalar)meeting.at[1];
    point.m_combinedFriction = friction;
    getNewManifold(&one, &other)->addManifoldPoint(point);
}

void Meetings::dispatchAllCollisionPairs(btOverlappingPairCache* cache,
                                         const btDispatcherInfo& info, btDispatcher* /*self*/) {
    while (getNumManifolds() > 0)
        releaseManifold(getManifoldByIndexInternal(getNumManifolds() - 1));

    // Bullet's pairs come in an order that depends on what was where before
    pair.clear();
    for (int i = 0; i < cache->getNumOverlappingPairs(); i++) {
        const btBroadphasePair& met = cache->getOverlappingPairArray()[i];
        const int a = ((const btCollisionObject*)met.m_pProxy0->m_clientObject)->getUserIndex();
        const int b = ((const btCollisionObject*)met.m_pProxy1->m_clientObject)->getUserIndex();
        // walls count from -1 downwards in Bullet, and behind the balls here
        const int count = (int)ball->size();
        const int first = a < 0 ? count - 1 - a : a, second = b < 0 ? count - 1 - b : b;
        pair.emplace_back(std::min(first, second), std::max(first, second));
    }
    std::sort(pair.begin(), pair.end());
    for (const auto& [first, second] : pair)
        meet(first, second, info.m_timeStep);
}

Bullet::Bullet()
    : meetings(&configuration), world(&meetings, &broadphase, &solver, &configuration) {
    meetings.ball = &ball;
    meetings.wall = &wall;
    meetings.setDispatcherFlags(btCollisionDispatcher::CD_USE_RELATIVE_CONTACT_BREAKING_THRESHOLD);
    world.setGravity(btVector3(0, 0, 0));

    // boxes of the whole path in the step
    world.getDispatchInfo().m_useContinuous = true;
    // one order for all contacts, and rows without SIMD, so that every machine gives the same bits
    world.getSimulationIslandManager()->setSplitIslands(false);
    solver.setConstraintRowSolverGeneric(solver.getScalarConstraintRowSolverGeneric());
    solver.setConstraintRowSolverLowerLimit(solver.getScalarConstraintRowSolverLowerLimit());
    btContactSolverInfo& info = world.getSolverInfo();
    info.m_solverMode = SOLVER_USE_2_FRICTION_DIRECTIONS;
    info.m_numIterations = ROUNDS;
    // overlaps part by velocity, and only as fast as `least_parting` says
    info.m_splitImpulse = 0;
    info.m_erp2 = 1;
}

Bullet::~Bullet() {
    for (const auto& each : ball)
        world.removeRigidBody(&each->body);
    for (const auto& each : wall)
        world.removeRigidBody(&each->body);
    while (meetings.getNumManifolds() > 0)
        meetings.releaseManifold(meetings.getManifoldByIndexInternal(0));
}

Bullet* bullet_open(void) {
    return new Bullet;
}

void bullet_close(Bullet* bullet) {
    delete bullet;
}

void bullet_add_plane(Bullet* bullet, const double point[3], const double normal[3]) {
    const double4 n = {normal[0], normal[1], normal[2], 0};
    const double4 p = {point[0], point[1], point[2], 0};
    const double4 unit = n / dlength(n);
    bullet->wall.push_back(std::make_unique<Wall>(unit, ddot(unit, p)));
    btRigidBody& body = bullet->wall.back()->body;
    body.setUserIndex(-(int)bullet->wall.size());
    bullet->world.addRigidBody(&body);
}

void bullet_solve(Bullet* bullet, Sphere* sphere, int count, double h) {
    bodies_follow(bullet, sphere, count);
    for (int i = 0; i < count; i++)
        copy_in(*bullet->ball[i], sphere[i]);
    bullet->meetings.sphere = sphere;
    bullet->world.stepSimulation((btScalar)h, 0);
    for (int i = 0; i < count; i++)
        copy_out(*bullet->ball[i], &sphere[i]);
}
