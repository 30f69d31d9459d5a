/// SIMD vectors, for kernels that compute the same for many particles or elements.
///
/// Arrays hold groups of eight numbers on every machine. A `lanes` holds WIDE of them, as many as a
/// register, and a kernel walks through the eight in steps of WIDE. (gcc keeps vectors that are
/// wider than a register in memory and compares them number by number.)
///
/// Operators act lane by lane. A kernel's file is compiled for the baseline of an architecture and
/// for newer machines (base/cpu.h). All that differs between them is in this file: it moves data
/// only, so the bits are the same as long as sums over lanes run in the order of the lanes. Masks
/// are integers of the same size: all bits set where true.
#ifndef BALLOON_BASE_LANES_H
#define BALLOON_BASE_LANES_H

#include <stdint.h>

#include "base/vec.h"

#ifdef __SSE2__
#include <immintrin.h> // 50,000 lines: headers that need the count only include base/vec.h
#endif

#if defined(__AVX__) && !defined(BALLOON_DOUBLE)
#define WIDE 8 ///< numbers in a `lanes`
#else
#define WIDE 4
#endif

enum { VECTORS = WIDE / 4 }; ///< real4 in a `lanes`

#ifdef BALLOON_DOUBLE
typedef int64_t lane_bits;
#else
typedef int32_t lane_bits;
#endif
typedef real lanes __attribute__((vector_size(WIDE * sizeof(real))));
typedef lane_bits lane_mask __attribute__((vector_size(WIDE * sizeof(real))));
typedef double lanes_double __attribute__((vector_size(WIDE * sizeof(double))));

/// Where the `lanes` that holds number n begins within its group of eight, for n a multiple of
/// WIDE.
static inline int lane_of(int n) {
    return WIDE == LANES ? 0 : n % LANES;
}

/// WIDE vectors in space.
typedef struct Lanes3 {
    lanes x, y, z;
} Lanes3;

static inline lanes lanes_load(const real* a) {
    lanes v;
    __builtin_memcpy(&v, a, sizeof v);
    return v;
}

static inline void lanes_store(real* a, lanes v) {
    __builtin_memcpy(a, &v, sizeof v);
}

static inline lanes lanes_select(lane_mask which, lanes yes, lanes no) {
    return (lanes)((which & (lane_mask)yes) | (~which & (lane_mask)no));
}

/// Absolute values.
static inline lanes lanes_abs(lanes a) {
    const lanes minus = -(lanes){0};
    return (lanes)((lane_mask)a & ~(lane_mask)minus);
}

/// Minimum and maximum lane by lane; b where one is not a number.
static inline lanes lanes_min(lanes a, lanes b) {
#if WIDE == 8
    return (lanes)_mm256_min_ps((__m256)a, (__m256)b);
#else
    return lanes_select(a < b, a, b);
#endif
}

static inline lanes lanes_max(lanes a, lanes b) {
#if WIDE == 8
    return (lanes)_mm256_max_ps((__m256)a, (__m256)b);
#else
    return lanes_select(a > b, a, b);
#endif
}

/// Square roots, correctly rounded, by the widest instruction of the machine.
static inline lanes lanes_sqrt(lanes a) {
#if defined(__AVX__) && defined(BALLOON_DOUBLE)
#define PIECE __m256d
#define PIECE_SQRT _mm256_sqrt_pd
#elif defined(__AVX__)
#define PIECE __m256
#define PIECE_SQRT _mm256_sqrt_ps
#elif defined(__SSE2__) && defined(BALLOON_DOUBLE)
#define PIECE __m128d
#define PIECE_SQRT _mm_sqrt_pd
#elif defined(__SSE2__)
#define PIECE __m128
#define PIECE_SQRT _mm_sqrt_ps
#else
#define PIECE real
#define PIECE_SQRT real_sqrt
#endif
    enum { PIECES = sizeof(lanes) / sizeof(PIECE) };
    PIECE piece[PIECES];
    __builtin_memcpy(piece, &a, sizeof a);
    for (int k = 0; k < PIECES; k++)
        piece[k] = PIECE_SQRT(piece[k]);
    __builtin_memcpy(&a, piece, sizeof a);
    return a;
#undef PIECE
#undef PIECE_SQRT
}

static inline Lanes3 lanes3_minus(Lanes3 a, Lanes3 b) {
    return (Lanes3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline Lanes3 lanes3_plus(Lanes3 a, Lanes3 b) {
    return (Lanes3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline Lanes3 lanes3_times(lanes s, Lanes3 a) {
    return (Lanes3){s * a.x, s * a.y, s * a.z};
}

static inline lanes lanes3_dot(Lanes3 a, Lanes3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline Lanes3 lanes3_cross(Lanes3 a, Lanes3 b) {
    return (Lanes3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

#if WIDE == 8

/// Two real4 as one `lanes`, and back.
static inline lanes lanes_join(real4 low, real4 high) {
    return (lanes)_mm256_insertf128_ps(_mm256_castps128_ps256((__m128)low), (__m128)high, 1);
}

static inline real4 lanes_low(lanes a) {
    return (real4)_mm256_castps256_ps128((__m256)a);
}

static inline real4 lanes_high(lanes a) {
    return (real4)_mm256_extractf128_ps((__m256)a, 1);
}

/// Transpose: x, y and z of vectors in space.
static inline Lanes3 lanes3_of(real4 a0, real4 a1, real4 a2, real4 a3, real4 a4, real4 a5, real4 a6,
                               real4 a7) {
    const __m256 a = (__m256)lanes_join(a0, a4), b = (__m256)lanes_join(a1, a5);
    const __m256 c = (__m256)lanes_join(a2, a6), d = (__m256)lanes_join(a3, a7);
    const __m256 ab = _mm256_unpacklo_ps(a, b), ab_z = _mm256_unpackhi_ps(a, b);
    const __m256 cd = _mm256_unpacklo_ps(c, d), cd_z = _mm256_unpackhi_ps(c, d);
    return (Lanes3){(lanes)_mm256_shuffle_ps(ab, cd, 0x44), (lanes)_mm256_shuffle_ps(ab, cd, 0xee),
                    (lanes)_mm256_shuffle_ps(ab_z, cd_z, 0x44)};
}

/// Transpose back: vectors one after the other, spare lanes zero.
static inline void lanes3_store(real4* out, Lanes3 v) {
    const __m256 x = (__m256)v.x, y = (__m256)v.y, z = (__m256)v.z, zero = _mm256_setzero_ps();
    const __m256 xy = _mm256_unpacklo_ps(x, y), xy_high = _mm256_unpackhi_ps(x, y);
    const __m256 z0 = _mm256_unpacklo_ps(z, zero), z0_high = _mm256_unpackhi_ps(z, zero);
    const lanes a = (lanes)_mm256_shuffle_ps(xy, z0, 0x44),
                b = (lanes)_mm256_shuffle_ps(xy, z0, 0xee);
    const lanes c = (lanes)_mm256_shuffle_ps(xy_high, z0_high, 0x44);
    const lanes d = (lanes)_mm256_shuffle_ps(xy_high, z0_high, 0xee);
    out[0] = lanes_low(a), out[1] = lanes_low(b), out[2] = lanes_low(c), out[3] = lanes_low(d);
    out[4] = lanes_high(a), out[5] = lanes_high(b), out[6] = lanes_high(c), out[7] = lanes_high(d);
}

#else

/// Transpose 4 x 4, by the shuffles of a machine with four such numbers in a register.
static inline void lanes_transpose(real4 a, real4 b, real4 c, real4 d, real4 out[4]) {
#if defined(BALLOON_DOUBLE) && !defined(__AVX__)
    for (int k = 0; k < 4; k++)
        out[k] = (real4){a[k], b[k], c[k], d[k]};
#elif defined(BALLOON_DOUBLE)
    const real4 even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
    const real4 odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const real4 even2 = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    const real4 odd2 = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    out[0] = __builtin_shufflevector(even, even2, 0, 1, 4, 5);
    out[1] = __builtin_shufflevector(odd, odd2, 0, 1, 4, 5);
    out[2] = __builtin_shufflevector(even, even2, 2, 3, 6, 7);
    out[3] = __builtin_shufflevector(odd, odd2, 2, 3, 6, 7);
#else
    const real4 low = __builtin_shufflevector(a, b, 0, 4, 1, 5);
    const real4 high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    const real4 low2 = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    const real4 high2 = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    out[0] = __builtin_shufflevector(low, low2, 0, 1, 4, 5);
    out[1] = __builtin_shufflevector(low, low2, 2, 3, 6, 7);
    out[2] = __builtin_shufflevector(high, high2, 0, 1, 4, 5);
    out[3] = __builtin_shufflevector(high, high2, 2, 3, 6, 7);
#endif
}

static inline Lanes3 lanes3_of(real4 a0, real4 a1, real4 a2, real4 a3) {
    real4 column[4];
    lanes_transpose(a0, a1, a2, a3, column);
    return (Lanes3){column[0], column[1], column[2]};
}

static inline void lanes3_store(real4* out, Lanes3 v) {
    const real4 zero = {0, 0, 0, 0};
    lanes_transpose(v.x, v.y, v.z, zero, out);
}

#endif

/// The x, y and z of AT(0), AT(1) … of type real4.
#if WIDE == 8
#define LANES3_OF(AT) lanes3_of(AT(0), AT(1), AT(2), AT(3), AT(4), AT(5), AT(6), AT(7))
#else
#define LANES3_OF(AT) lanes3_of(AT(0), AT(1), AT(2), AT(3))
#endif

static inline Lanes3 lanes3_load(const real4* a) {
#define AT(k) a[k]
    return LANES3_OF(AT);
#undef AT
}

/// The vectors at WIDE byte offsets from the start of an array.
static inline Lanes3 lanes3_gather(const real4* array, const uint32_t* offset) {
#define AT(k) (*(const real4*)((const char*)array + offset[k]))
    return LANES3_OF(AT);
#undef AT
}

/// The same four numbers in each four lanes.
static inline lanes lanes_repeat(real4 a) {
#if WIDE == 8
    return lanes_join(a, a);
#else
    return a;
#endif
}

/// a[0] in the first four lanes, a[1] in the next four if there are eight.
static inline lanes lanes_each(const real* a) {
    const real4 low = {a[0], a[0], a[0], a[0]};
#if WIDE == 8
    const real4 high = {a[1], a[1], a[1], a[1]};
    return lanes_join(low, high);
#else
    return low;
#endif
}

/// sum[k % 4] += a[k], in the order of the lanes.
static inline void lanes_sum(double4* sum, lanes a) {
#if WIDE == 8
    *sum += to_double4(lanes_low(a));
    *sum += to_double4(lanes_high(a));
#else
    *sum += to_double4(a);
#endif
}

/// sum[k / 4][k % 4] += a[k - lane] for k = lane … lane + WIDE - 1: each four lanes have their own
/// sum.
static inline void lanes_sum_apart(double4* sum, int lane, lanes a) {
#if WIDE == 8
    sum[lane / 4] += to_double4(lanes_low(a));
    sum[lane / 4 + 1] += to_double4(lanes_high(a));
#else
    sum[lane / 4] += to_double4(a);
#endif
}

#endif
