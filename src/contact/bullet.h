/// Bullet's part, a C face on flat arrays: which triangles of a skin are near a ball, and what
/// balls, floor and walls do to each other.
///
/// Bullet keeps no state of ours: before each call positions and velocities are copied in, after it
/// velocities are copied out. A skin is in patches of 64 triangles over the caller's own arrays; the
/// boxes of the patches follow the skin and stand in one of Bullet's trees of boxes (btDbvt), which
/// finds the patches near a ball. Bullet's own test of a sphere against each triangle is not used:
/// it told nothing that the contact's nearest point does not tell again, and took 60 % of the time
/// of all contacts.
#ifndef BALLOON_CONTACT_BULLET_H
#define BALLOON_CONTACT_BULLET_H

#include "contact/sphere.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct Bullet Bullet;
typedef struct BulletSkin BulletSkin;

Bullet* bullet_open(void);
void bullet_close(Bullet* bullet);

/// A static half-space: the floor or a wall. Balls stay on the side that the unit normal points to.
/// friction multiplies the ball's own; restitution is the ball's.
void bullet_add_plane(Bullet* bullet, const double point[3], const double normal[3]);

/// Velocities and spins of all balls after h of sphere against sphere and sphere against plane:
/// Bullet's own sequential impulses, scalar code path on every machine. Gravity has been added
/// already by the caller; positions are read, not moved. Bodies follow the count, which may change
/// from call to call.
void bullet_solve(Bullet* bullet, Sphere* sphere, int count, double h);

/// A skin over the caller's arrays, which must outlive it: triangle [triangle_count] of particle
/// numbers, x [point_count] positions, read at the time of each call.
BulletSkin* bullet_skin_open(const int (*triangle)[3], int triangle_count, const real4* x,
                             int point_count);
void bullet_skin_close(BulletSkin* skin);

/// Boxes of the patches to where the skin is now, grown by `margin` [m].
void bullet_skin_refit(BulletSkin* skin, double margin);

/// The box of the whole skin at the last refit.
void bullet_skin_box(const BulletSkin* skin, double low[3], double high[3]);

/// All triangles within `reach` of a point and some whose boxes are, each once, in rising order; at
/// most `capacity` are stored in `triangle`. Returns how many there are, which may be more.
int bullet_skin_near(BulletSkin* skin, const double center[3], double reach, int* triangle,
                     int capacity);

#ifdef __cplusplus
}
#endif

#endif
