#include "lab/peer/peer.h"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>
#include <vector>

// Bullet's headers must know which of its two builds is linked
#if defined(BALLOON_DOUBLE) && !defined(BT_USE_DOUBLE_PRECISION)
#define BT_USE_DOUBLE_PRECISION
#endif
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

static_assert(sizeof(btScalar) == sizeof(real), "Bullet's precision is the precision of the state");

namespace {

// Bullet stores a ball's distance field in voxels, by default of 0.25 m: so many per radius of the
// smallest ball give an error below a hundredth of that radius.
constexpr double VOXELS = 4;

struct Ball {
    btSphereShape shape;
    btRigidBody body;

    explicit Ball(const Sphere& sphere);
};

struct Plate {
    btBoxShape shape;
    btRigidBody body;

    Plate(const btTransform& middle, btScalar size);
};

btVector3 bullet_vector(double4 a) {
    return btVector3((btScalar)a[0], (btScalar)a[1], (btScalar)a[2]);
}

double4 our_vector(const btVector3& a) {
    return double4{(double)a.x(), (double)a.y(), (double)a.z(), 0};
}

btRigidBody::btRigidBodyConstructionInfo body_of(const Sphere& sphere, btCollisionShape* shape) {
    const btScalar inertia = sphere_inertia(&sphere);
    btRigidBody::btRigidBodyConstructionInfo info(sphere.mass, nullptr, shape,
                                                  btVector3(inertia, inertia, inertia));
    info.m_startWorldTransform =
        btTransform(btMatrix3x3::getIdentity(), bullet_vector(to_double4(sphere.x)));
    info.m_friction = sphere.friction;
    info.m_restitution = sphere.restitution;
    return info;
}

Ball::Ball(const Sphere& sphere) : shape(sphere.radius), body(body_of(sphere, &shape)) {
    body.setLinearVelocity(bullet_vector(to_double4(sphere.v)));
    body.setAngularVelocity(bullet_vector(to_double4(sphere.spin)));
    body.setActivationState(DISABLE_DEACTIVATION);
}

btRigidBody::btRigidBodyConstructionInfo body_of_plate(const btTransform& middle,
                                                       btCollisionShape* shape) {
    btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, shape);
    info.m_startWorldTransform = middle;
    info.m_friction = 0;
    return info;
}

Plate::Plate(const btTransform& middle, btScalar size)
    : shape(btVector3(size / 2, size / 2, size / 2)), body(body_of_plate(middle, &shape)) {
}

std::vector<btVector3> points_of(const PeerDef& def) {
    std::vector<btVector3> point;
    for (int i = 0; i < def.point_count; i++)
        point.push_back(bullet_vector(def.point[i]));
    return point;
}

/// Each edge once.
std::set<std::pair<int, int>> edges_of(const PeerDef& def) {
    std::set<std::pair<int, int>> edge;
    for (int t = 0; t < def.triangle_count; t++)
        for (int k = 0; k < 3; k++)
            edge.insert(std::minmax({def.triangle[t][k], def.triangle[t][(k + 1) % 3]}));
    return edge;
}

void append_rod(btSoftBody* skin, const PeerRod& rod) {
    skin->appendNode(bullet_vector(rod.to), 0);
    skin->appendLink(rod.point, skin->m_nodes.size() - 1);
    btSoftBody::Link& link = skin->m_links[skin->m_links.size() - 1];
    link.m_rl = (btScalar)rod.length;
    link.m_c1 = link.m_rl * link.m_rl;
}

} // namespace

struct Peer {
    btSoftBodyRigidBodyCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher;
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btSoftRigidDynamicsWorld world;
    btSoftBody skin;
    int point_count; ///< of the skin's nodes; rods' ends come after them
    std::vector<std::unique_ptr<Ball>> ball;
    std::vector<std::unique_ptr<Plate>> plate;
    double smallest = 0; ///< radius of the smallest ball [m]

    explicit Peer(const PeerDef& def);
    ~Peer();
};

Peer::Peer(const PeerDef& def)
    : dispatcher(&configuration), world(&dispatcher, &broadphase, &solver, &configuration),
      skin(&world.getWorldInfo(), def.point_count, points_of(def).data(), nullptr),
      point_count(def.point_count) {
    world.setGravity(btVector3(0, (btScalar)-def.gravity, 0));
    world.getWorldInfo().m_gravity = btVector3(0, (btScalar)(def.lift - def.gravity), 0); // its own

    for (const auto& [a, b] : edges_of(def))
        skin.appendLink(a, b);
    for (int t = 0; t < def.triangle_count; t++)
        skin.appendFace(def.triangle[t][0], def.triangle[t][1], def.triangle[t][2]);
    skin.randomizeConstraints(); // as in Bullet's own setup: rounds converge faster
    skin.setTotalMass((btScalar)def.mass);
    for (int i = 0; def.held && i < def.point_count; i++)
        if (def.held[i])
            skin.setMass(i, 0);
    for (int k = 0; k < def.rod_count; k++)
        append_rod(&skin, def.rod[k]);

    skin.m_materials[0]->m_kLST = (btScalar)def.stiffness;
    skin.m_cfg.kPR = (btScalar)def.pressure;
    skin.m_cfg.kDP = (btScalar)def.damping;
    skin.m_cfg.kDF = (btScalar)def.friction;
    skin.m_cfg.piterations = def.position_rounds;
    skin.m_cfg.viterations = def.velocity_rounds;
    if (def.velocity_rounds > 0) // with an empty sequence Bullet's velocity rounds do nothing
        skin.m_cfg.m_vsequence.push_back(btSoftBody::eVSolver::Linear);
    skin.m_cfg.collisions = btSoftBody::fCollision::SDF_RS;
    skin.getCollisionShape()->setMargin((btScalar)def.margin);
    skin.setActivationState(DISABLE_DEACTIVATION);
    world.addSoftBody(&skin);
}

Peer::~Peer() {
    for (const auto& each : ball)
        world.removeRigidBody(&each->body);
    for (const auto& each : plate)
        world.removeRigidBody(&each->body);
    world.removeSoftBody(&skin);
}

PeerDef peer_def_default(void) {
    PeerDef def = {};
    def.mass = 1;
    def.stiffness = 1;
    def.friction = 0.2;
    def.position_rounds = 1;
    return def;
}

Peer* peer_open(const PeerDef* def) {
    return new Peer(*def);
}

void peer_add_sphere(Peer* peer, const Sphere* sphere) {
    peer->ball.push_back(std::make_unique<Ball>(*sphere));
    peer->world.addRigidBody(&peer->ball.back()->body);
    const double radius = (double)sphere->radius;
    peer->smallest = peer->ball.size() == 1 ? radius : std::min(peer->smallest, radius);
    peer->world.getWorldInfo().m_sparsesdf.Reset();
    peer->world.getWorldInfo().m_sparsesdf.setDefaultVoxelsz((btScalar)(peer->smallest / VOXELS));
}

void peer_add_plate(Peer* peer, double4 point, double4 normal, double size) {
    const btVector3 up(0, 1, 0), n = bullet_vector(normal);
    const btTransform middle(shortestArcQuat(up, n), bullet_vector(point - size / 2 * normal));
    peer->plate.push_back(std::make_unique<Plate>(middle, (btScalar)size));
    peer->world.addRigidBody(&peer->plate.back()->body);
}

void peer_set_pressure(Peer* peer, double pressure) {
    peer->skin.m_cfg.kPR = (btScalar)pressure;
}

void peer_step(Peer* peer, double h) {
    peer->world.stepSimulation((btScalar)h, 0); // 0: this one step, as long as it is
}

void peer_read(const Peer* peer, double4* x, double4* v) {
    for (int i = 0; i < peer->point_count; i++) {
        if (x)
            x[i] = our_vector(peer->skin.m_nodes[i].m_x);
        if (v)
            v[i] = our_vector(peer->skin.m_nodes[i].m_v);
    }
}

void peer_read_sphere(const Peer* peer, int sphere, double4* x, double4* v) {
    const btRigidBody& body = peer->ball[sphere]->body;
    *x = our_vector(body.getCenterOfMassPosition());
    *v = our_vector(body.getLinearVelocity());
}

int peer_contacts(const Peer* peer, int sphere) {
    int count = 0;
    for (int k = 0; k < peer->skin.m_rcontacts.size(); k++)
        count += peer->skin.m_rcontacts[k].m_cti.m_colObj == &peer->ball[sphere]->body;
    return count;
}

double peer_volume(const Peer* peer) {
    return (double)peer->skin.getVolume();
}

void peer_close(Peer* peer) {
    delete peer;
}
