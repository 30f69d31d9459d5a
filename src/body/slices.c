#include "body/slices.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "mesh/counting_sort.h"

/// A neighbor, and the particle's end of its spring to it.
typedef struct Slot {
    int neighbor, end;
} Slot;

/// The input of slices_make, and the slots of the particle at hand.
typedef struct Maker {
    const Mesh* mesh;
    const Springs* springs;
    int* spring_from; ///< [count + 1] where a particle's springs begin in `spring`
    int* spring;      ///< 2 s + k for its end k of spring s
    int* met;         ///< [count] the particle's end of its spring to a neighbor, or NONE
    int (*beside)[2]; ///< [count] the particle's faces whose b, and whose d, is a neighbor, or NONE
    int faces;        ///< pairs of slots in the particle's ring
    int slots;
    int* neighbor; ///< [slots]
    int* end;      ///< [slots] as in `spring`, or NONE
    Slot* slot;    ///< [slots] those that are sorted
} Maker;

/// Corners of a face around point a: b after it, c across, d before.
typedef struct Corners {
    int b, c, d;
} Corners;

static Corners corners_at(const Mesh* mesh, int face, int a) {
    const int* corner = mesh->face[face];
    const int corners = face_corners(corner);
    int k = 0;
    while (corner[k] != a)
        k++;
    const int b = corner[(k + 1) % corners];
    return (Corners){b, corners == 4 ? corner[(k + 2) % 4] : b,
                     corner[(k + corners - 1) % corners]};
}

/// A face is counted at its corner of the lowest number: one of each, for a quad mesh has about as
/// many faces as points, and next to each other, for points are numbered along a front.
static bool is_lowest(int a, Corners corners) {
    return a < corners.b && a < corners.c && a < corners.d;
}

/// Enter the faces of a point at its neighbors, so that a walk around it takes linear time at any
/// valence; or take them out again.
static void enter_faces(Maker* maker, int a, bool in) {
    const Mesh* mesh = maker->mesh;
    for (int k = mesh->point_face_from[a + 1] - 1; k >= mesh->point_face_from[a]; k--) {
        const int face = mesh->point_face[k];
        const Corners here = corners_at(mesh, face, a);
        maker->beside[here.b][0] = in ? face : NONE;
        maker->beside[here.d][1] = in ? face : NONE;
    }
}

/// Where a walk around a point begins: the first face of a fan; on a closed ring where those begin
/// that are counted at it, if any.
static Corners first_face(const Maker* maker, int a) {
    const Mesh* mesh = maker->mesh;
    const int *from = &mesh->point_face[mesh->point_face_from[a]],
              *to = &mesh->point_face[mesh->point_face_from[a + 1]];
    Corners first = corners_at(mesh, *from, a);
    for (const int* f = from; f < to; f++) {
        const Corners here = corners_at(mesh, *f, a);
        const int before = maker->beside[here.b][1];
        if (before == NONE)
            return here;
        if (is_lowest(a, here) && !is_lowest(a, corners_at(mesh, before, a)))
            first = here;
    }
    return first;
}

/// Fill `ring` with b and c of the faces around a point, in order; returns the number of pairs. The
/// mesh doctor refuses points where two rings touch, so there is one ring.
static int find_ring(Maker* maker, int a, int (*ring)[2]) {
    const Mesh* mesh = maker->mesh;
    const int faces = mesh->point_face_from[a + 1] - mesh->point_face_from[a];
    enter_faces(maker, a, true);
    Corners now = first_face(maker, a);
    const int first = now.b;
    for (int k = 0; k < faces; k++) {
        ring[k][0] = now.b;
        ring[k][1] = now.c;
        if (k + 1 < faces)
            now = corners_at(mesh, maker->beside[now.d][0], a);
    }
    enter_faces(maker, a, false);
    if (now.d == first)
        return faces;
    ring[faces][0] = now.d;
    ring[faces][1] = a;
    return faces + 1;
}

static void put(Maker* maker, int neighbor) {
    maker->neighbor[maker->slots] = neighbor;
    maker->end[maker->slots++] = maker->met[neighbor];
    maker->met[neighbor] = NONE; // a neighbor that comes twice has its spring once
}

static int by_neighbor(const void* a, const void* b) {
    const int i = ((const Slot*)a)->neighbor, j = ((const Slot*)b)->neighbor;
    return (i > j) - (i < j);
}

/// Slots beside the ring, by the numbers of their neighbors: then they are in the same directions
/// all along a front.
static void sort_remaining(Maker* maker) {
    const int from = 2 * maker->faces, count = maker->slots - from;
    for (int k = 0; k < count; k++)
        maker->slot[k] = (Slot){maker->neighbor[from + k], maker->end[from + k]};
    qsort(maker->slot, (size_t)count, sizeof *maker->slot, by_neighbor);
    for (int k = 0; k < count; k++) {
        maker->neighbor[from + k] = maker->slot[k].neighbor;
        maker->end[from + k] = maker->slot[k].end;
    }
}

/// Make the slots of one particle: its ring, then the remaining springs.
static void make_lane(Maker* maker, int particle, int (*ring)[2]) {
    const Mesh* mesh = maker->mesh;
    const Springs* springs = maker->springs;
    const int from = springs ? maker->spring_from[particle] : 0;
    const int to = springs ? maker->spring_from[particle + 1] : 0;
    for (int k = from; k < to; k++) {
        const int end = maker->spring[k];
        maker->met[springs->end[end / 2][1 - end % 2]] = end;
    }
    maker->slots = maker->faces = 0;
    if (mesh) {
        maker->faces = find_ring(maker, particle, ring);
        for (int k = 0; k < 2 * maker->faces; k++)
            put(maker, ring[k / 2][k % 2]);
    }
    for (int k = from; k < to; k++) {
        const int end = maker->spring[k], neighbor = springs->end[end / 2][1 - end % 2];
        if (maker->met[neighbor] == end)
            put(maker, neighbor);
    }
    sort_remaining(maker);
}

/// Is face k of the maker's particle counted there?
static bool is_counted(const Maker* maker, int particle, int k) {
    const int* at = &maker->neighbor[2 * k];
    const int next = k + 1 < maker->faces ? at[2] : maker->neighbor[0];
    return is_lowest(particle, (Corners){at[0], at[1], next});
}

/// Count the slots of each slice, and the pairs up to its last counted face. Returns all slots.
static int count_slots(Slices* slices, Maker* maker, int count, int (*ring)[2]) {
    for (int s = 0; s < slices->count; s++) {
        int beside = 0, counted = 0;
        for (int i = s * LANES; i < s * LANES + LANES && i < count; i++) {
            make_lane(maker, i, ring);
            const int others = maker->slots - 2 * maker->faces;
            slices->faces[s] = maker->faces > slices->faces[s] ? maker->faces : slices->faces[s];
            beside = others > beside ? others : beside;
            for (int k = counted; k < maker->faces; k++)
                counted = is_counted(maker, i, k) ? k + 1 : counted;
        }
        slices->counted_from[s + 1] = slices->counted_from[s] + counted;
        slices->from[s + 1] = slices->from[s] + 2 * slices->faces[s] + beside;
    }
    return slices->from[slices->count];
}

/// Copy the slots of the maker's particle to its lane of the slice, and pad the rest.
static void copy_lane(Slices* slices, const Maker* maker, int particle) {
    const int slice = particle / LANES, lane = particle % LANES;
    const int ring = 2 * maker->faces, rings = 2 * slices->faces[slice];
    const int from = slices->from[slice], slots = slices->from[slice + 1] - from;
    for (int k = 0; k < slots; k++) {
        const int own = k < rings ? (k < ring ? k : NONE) : k - rings + ring;
        const bool is = own != NONE && own < maker->slots;
        const int neighbor = is ? maker->neighbor[own] : ring ? maker->neighbor[0] : particle;
        slices->offset[from + k][lane] = (uint32_t)((size_t)neighbor * sizeof(real4));
        if (!is || maker->end[own] == NONE)
            continue;
        const int end = maker->end[own];
        slices->rest[from + k][lane] = maker->springs->rest[end / 2];
        slices->stiffness[from + k][lane] = maker->springs->active[end / 2];
        slices->spring[end / 2][end % 2] = (from + k) * LANES + lane;
    }
    for (int k = 0; k < maker->faces; k++)
        if (is_counted(maker, particle, k))
            slices->counted[slices->counted_from[slice] + k][lane] = 1;
}

static bool is_contiguous(const uint32_t offset[LANES]) {
    for (int k = 1; k < LANES; k++)
        if (offset[k] != offset[k - 1] + sizeof(real4))
            return false;
    return true;
}

static int max_difference(const int* from, int count) {
    int max = 0;
    for (int i = 0; i < count; i++)
        max = from[i + 1] - from[i] > max ? from[i + 1] - from[i] : max;
    return max;
}

void slices_make(Slices* slices, int count, const Mesh* mesh, const Springs* springs) {
    *slices = (Slices){.count = (count + LANES - 1) / LANES};
    slices->from = new_array(int, slices->count + 1);
    slices->faces = new_array(int, slices->count);
    slices->counted_from = new_array(int, slices->count + 1);
    slices->sum = new_array(double[5], parts_of(slices->count, PART_SLICES));
    Maker maker = {.mesh = mesh,
                   .springs = springs,
                   .met = new_array(int, count),
                   .beside = new_array(int[2], count)};
    for (int i = 0; i < count; i++)
        maker.met[i] = maker.beside[i][0] = maker.beside[i][1] = NONE;
    slices->open = mesh && !mesh->closed;
    const int pairs = mesh ? max_difference(mesh->point_face_from, count) + 1 : 0;
    int(*ring)[2] = new_array(int[2], pairs);

    int max = 2 * pairs;
    if (springs) {
        maker.spring_from = new_array(int, count + 1);
        maker.spring = new_array(int, 2 * springs->count);
        counting_sort(springs->end[0], 2 * springs->count, count, maker.spring_from, maker.spring);
        max += max_difference(maker.spring_from, count);
        slices->spring = new_array(int[2], springs->count);
    }
    maker.neighbor = new_array(int, max);
    maker.end = new_array(int, max);
    maker.slot = new_array(Slot, max);

    const int slots = count_slots(slices, &maker, count, ring);
    slices->offset = new_array(uint32_t[LANES], slots);
    slices->counted = new_array(real[LANES], slices->counted_from[slices->count]);
    if (springs) {
        slices->stiffness = new_array(real[LANES], slots);
        slices->rest = new_array(real[LANES], slots);
    }
    for (int i = 0; i < count; i++) {
        make_lane(&maker, i, ring);
        copy_lane(slices, &maker, i);
    }
    slices->contiguous = new_array(bool, slots);
    for (int k = 0; k < slots; k++)
        slices->contiguous[k] = is_contiguous(slices->offset[k]);
    for (int k = 0; k < 3; k++)
        slices->coordinate[k] = new_array(real, slices->count * LANES);
    free(ring);
    free(maker.met);
    free(maker.beside);
    free(maker.spring_from);
    free(maker.spring);
    free(maker.neighbor);
    free(maker.end);
    free(maker.slot);
}

void slices_free(Slices* slices) {
    free(slices->from);
    free(slices->faces);
    free(slices->counted_from);
    free(slices->counted);
    free(slices->sum);
    free(slices->offset);
    free(slices->contiguous);
    for (int k = 0; k < 3; k++)
        free(slices->coordinate[k]);
    free(slices->stiffness);
    free(slices->rest);
    free(slices->spring);
    *slices = (Slices){0};
}
