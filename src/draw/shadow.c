#include "draw/shadow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/real.h"
#include "base/memory.h"

// Direction to the center of the key light, x and z for y = 1; the same as KEY in studio.glsl.
static const float KEY_X = -0.45f, KEY_Z = 0.35f;
// Half-mass radius of a shadow over the height of its caster: under the sky, under the soft box.
static const float SKY_SPREAD = 1.0f, KEY_SPREAD = 0.28f;
// Optical depth of a layer in contact with the floor, from each light: exp(-1.7) passes both.
static const float SKY_SHARE = 0.8f, KEY_SHARE = 0.9f;
// Transmission of rubber for light of its own color.
static const float TRANSMISSION = 0.55f;
// Absorption of a faint shape over that of rubber.
static const float FAINT = 0.35f;
// Half-mass radius of one B-spline bump in spacings of its grid.
static const float BUMP = 0.8f;
// A large triangle is split along each side into at most so many pieces.
enum { PIECES = 12 };

// Data that all pieces of one picture share.
typedef struct Cast {
    Shadow* shadow;
    float corner_x, corner_z, floor;
    float per_unit; // cells of the finest grid per world unit
} Cast;

static int side(int level) {
    return (SHADOW_CELLS >> level) + 1;
}

Shadow shadow_open(void) {
    Shadow shadow;
    for (int k = 0; k < SHADOW_LEVELS; k++)
        shadow.level[k] = new_array(float4, side(k) * side(k));
    shadow.light = memory_array(SHADOW_SIDE * SHADOW_SIDE, sizeof shadow.light[0]);
    return shadow;
}

void shadow_close(Shadow* shadow) {
    for (int k = 0; k < SHADOW_LEVELS; k++)
        free(shadow->level[k]);
    free(shadow->light);
    *shadow = (Shadow){0};
}

// Add to the four points around (x, z), in cells of the finest grid.
static void splat(float4* grid, int level, float x, float z, float4 amount) {
    const float scale = 1.0f / (float)(1 << level);
    const float u = x * scale, v = z * scale;
    const int n = side(level);
    if (!(u >= 0 && v >= 0 && u < (float)(n - 1) && v < (float)(n - 1)))
        return;

    const int i = (int)u, j = (int)v;
    const float a = u - (float)i, b = v - (float)j;
    float4* at = grid + j * n + i;
    amount *= scale * scale; // the same integral over larger cells
    at[0] += (1 - a) * (1 - b) * amount;
    at[1] += a * (1 - b) * amount;
    at[n] += (1 - a) * b * amount;
    at[n + 1] += a * b * amount;
}

// A bump of this half-mass radius [cells], shared between the two grids that fit it best.
static void bump(const Cast* cast, float x, float z, float radius, float4 amount) {
    const float fit = log2f(fmaxf(radius / BUMP, 1));
    const int level = fit < SHADOW_LEVELS - 2 ? (int)fit : SHADOW_LEVELS - 2;
    const float wider = fminf(fit - (float)level, 1);
    splat(cast->shadow->level[level], level, x, z, (1 - wider) * amount);
    splat(cast->shadow->level[level + 1], level + 1, x, z, wider * amount);
}

// Cast the shadow of a piece of surface at p; sky, key: its areas projected along each light's
// direction onto the floor [square units].
static void cast_piece(const Cast* cast, const float p[3], float sky, float key, float4 absorbed) {
    const float height = fmaxf(p[1] - cast->floor, 0);
    const float x = (p[0] - cast->corner_x) * cast->per_unit;
    const float z = (p[2] - cast->corner_z) * cast->per_unit;
    const float h = height * cast->per_unit, cells = cast->per_unit * cast->per_unit;

    if (sky > 0)
        bump(cast, x, z, SKY_SPREAD * h, SKY_SHARE * sky * cells * absorbed);
    if (key > 0)
        bump(cast, x - KEY_X * h, z - KEY_Z * h, KEY_SPREAD * h,
             KEY_SHARE * key * cells * absorbed);
}

static void cast_triangle(const Cast* cast, const float* a, const float* b, const float* c,
                          bool two_sided, float4 absorbed) {
    const float u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const float v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};

    // projected areas; a positive area faces away from the light
    const float nx = u[1] * v[2] - u[2] * v[1], ny = u[2] * v[0] - u[0] * v[2],
                nz = u[0] * v[1] - u[1] * v[0];
    float sky = -0.5f * ny, key = sky - 0.5f * (KEY_X * nx + KEY_Z * nz);
    if (two_sided) {
        sky = fabsf(sky);
        key = fabsf(key);
    }
    if (!(sky > 0 || key > 0))
        return;

    // enough pieces for their bumps to overlap
    const float wide = fmaxf(fmaxf(fabsf(u[0]), fabsf(u[2])), fmaxf(fabsf(v[0]), fabsf(v[2])));
    const int n = 1 + (int)fminf(wide * cast->per_unit, PIECES - 1);
    const float share = 1 / (float)(n * n), third = 1 / (3 * (float)n);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < 2 * (n - i) - 1; j++) {
            // even j: triangles oriented as the large one; odd j: the inverted ones between them
            const int inverted = j % 2, column = j / 2;
            const float s = (float)(3 * i + 1 + inverted) * third;
            const float t = (float)(3 * column + 1 + inverted) * third;
            const float p[3] = {a[0] + s * u[0] + t * v[0], a[1] + s * u[1] + t * v[1],
                                a[2] + s * u[2] + t * v[2]};
            cast_piece(cast, p, share * sky, share * key, absorbed);
        }
}

static void cast_skin(const Cast* cast, const PictureSkin* shape) {
    float4 absorbed = {1, 1, 1, 0};
    for (int i = 0; i < 3; i++)
        absorbed[i] -= TRANSMISSION * shape->color[i];
    if (shape->paint == PAINT_FAINT)
        absorbed *= FAINT;

    for (int i = 0; i < shape->triangle_count; i++) {
        const int* t = shape->triangle[i];
        cast_triangle(cast, shape->position[t[0]], shape->position[t[1]], shape->position[t[2]],
                      shape->two_sided, absorbed);
    }
}

// The lower half of a ball, in rings of pieces of equal area.
static void cast_ball(const Cast* cast, const PictureBall* shape) {
    enum { RINGS = 5, SPOKES = 10 };
    const float area = (float)PI * shape->radius * shape->radius / (RINGS * SPOKES);
    for (int i = 0; i < RINGS; i++) {
        const float square = ((float)i + 0.5f) / RINGS;
        const float across = shape->radius * sqrtf(square);
        const float below = shape->radius * sqrtf(1 - square);
        for (int j = 0; j < SPOKES; j++) {
            const float angle = 2 * (float)PI * ((float)j + 0.5f * (float)(i % 2)) / SPOKES;
            const float p[3] = {shape->center[0] + across * cosf(angle), shape->center[1] - below,
                                shape->center[2] + across * sinf(angle)};
            cast_piece(cast, p, area, area, (float4){1, 1, 1, 0});
        }
    }
}

// fine += coarse on a grid of half the spacing, by cubic B-spline subdivision: a point of both grids
// takes (1 6 1)/8 of itself and its neighbors, a point between two takes half of each.
static void widen(const float4* restrict coarse, int n, float4* restrict fine) {
    const int m = 2 * n - 1;
    for (int j = 0; j < m; j++) {
        const float4* row[3] = {coarse + (j / 2 > 0 ? j / 2 - 1 : 0) * n, coarse + j / 2 * n,
                                coarse + (j / 2 + 1 < n ? j / 2 + 1 : n - 1) * n};
        const float below = j % 2 ? 0 : 0.125f, middle = j % 2 ? 0.5f : 0.75f,
                    above = j % 2 ? 0.5f : 0.125f;
        float4 left = {0}, here = {0};
        for (int i = 0; i <= n; i++) {
            const float4 right =
                i < n ? below * row[0][i] + middle * row[1][i] + above * row[2][i] : (float4){0};
            if (i > 0) {
                fine[j * m + 2 * i - 2] += 0.125f * (left + 6 * here + right);
                if (i < n)
                    fine[j * m + 2 * i - 1] += 0.5f * (here + right);
            }
            left = here;
            here = right;
        }
    }
}

void shadow_cast(Shadow* shadow, const Picture* picture) {
    const float reach = shadow_reach(picture);
    const Cast cast = {.shadow = shadow,
                       .corner_x = picture->scene_center[0] - reach,
                       .corner_z = picture->scene_center[2] - reach,
                       .floor = picture->floor_height,
                       .per_unit = 0.5f * SHADOW_CELLS / reach};

    for (int k = 0; k < SHADOW_LEVELS; k++)
        memset(shadow->level[k], 0, (size_t)(side(k) * side(k)) * sizeof(float4));
    for (int i = 0; i < picture->skin_count; i++)
        if (picture->skin[i].paint != PAINT_GHOST)
            cast_skin(&cast, &picture->skin[i]);
    for (int i = 0; i < picture->ball_count; i++)
        cast_ball(&cast, &picture->ball[i]);

    // from the coarsest grid to the finest
    for (int k = SHADOW_LEVELS - 1; k > 0; k--)
        widen(shadow->level[k], side(k), shadow->level[k - 1]);

    // light passes one layer of rubber after another: exponential attenuation
    const float4* depth = shadow->level[0];
    for (int i = 0; i < SHADOW_SIDE * SHADOW_SIDE; i++)
        for (int k = 0; k < 3; k++)
            shadow->light[i][k] = (unsigned char)(255 * expf(-depth[i][k]) + 0.5f);
}
