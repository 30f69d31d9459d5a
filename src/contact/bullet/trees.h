/// Bullet's part: a C face of its trees of boxes (btDbvt), which find what may be near. All narrow
/// phases, times and impulses are ours, for one solver must see all contacts of a part.
///
/// A skin is in patches of 64 triangles over the caller's own arrays; the boxes of the patches
/// follow the skin and stand in one tree. The balls stand in another, in the boxes of their paths.
/// Bullet's test of a sphere against each triangle is not used: it found nothing that the contact's
/// nearest point does not find again, and took 60 % of the time of all contacts.
#ifndef BALLOON_CONTACT_BULLET_TREES_H
#define BALLOON_CONTACT_BULLET_TREES_H

#include "contact/sphere.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct BulletBalls BulletBalls;
typedef struct BulletSkin BulletSkin;

BulletBalls* bullet_balls_open(void);
void bullet_balls_close(BulletBalls* balls);

/// All pairs of balls, the lower number first and in rising order, whose paths x + t v, 0 <= t <= h,
/// may come within `margin` of touching [m], and some whose boxes do. The count of balls may change
/// from call to call. *pair: valid until the next call. Returns how many there are.
int bullet_balls_near(BulletBalls* balls, const Sphere* sphere, int count, double h, double margin,
                      const int (**pair)[2]);

/// A skin over the caller's arrays, which must outlive it: triangle [triangle_count] of particle
/// numbers, x [point_count] positions, read at the time of each call.
BulletSkin* bullet_skin_open(const int (*triangle)[3], int triangle_count, const real4* x,
                             int point_count);
void bullet_skin_close(BulletSkin* skin);

/// Boxes of the patches to where the skin is now; in the tree they are larger by `margin` on each
/// side [m].
void bullet_skin_refit(BulletSkin* skin, double margin);

/// The box of the whole skin at the last refit.
void bullet_skin_box(const BulletSkin* skin, double low[3], double high[3]);

/// All triangles within `reach` of a point and some whose boxes are, each once, in rising order; at
/// most `capacity` are stored in `triangle`. Returns how many there are, which may be more.
int bullet_skin_near(BulletSkin* skin, const double center[3], double reach, int* triangle,
                     int capacity);

/// All pairs of triangles of two skins within `reach` of each other, and some whose boxes are; of a
/// skin and itself each pair once, neighbours too. Both must have been refit where they are now, with
/// margins that sum to at least 1.01 times the reach. *pair: valid until the next search of the first
/// skin, in an order that depends on the skins alone. Returns how many there are.
int bullet_skin_near_triangles(BulletSkin* skin, const BulletSkin* other, double reach,
                               const int (**pair)[2]);

#ifdef __cplusplus
}
#endif

#endif
