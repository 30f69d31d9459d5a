/// Springs between the particles of a quad mesh, each unordered pair once, found in linear time.
///
///     structural  the two ends of an edge
///     shear       the two ends of a quad's diagonal; triangles have none
///     flexion     the two ends of a two-edge path that share no face
///
///       p --- . --- q      p-. structural, p-r shear, p-q flexion
///       |     |     |
///       . --- r --- .
///
/// A pair that two rules name belongs to the first. Source: the mass-spring balloon paper,
/// "Spring Generation"; counts in closed form are held by tests/unit/test_springs.c.
#ifndef BALLOON_BODY_SPRINGS_H
#define BALLOON_BODY_SPRINGS_H

#include "mesh/mesh.h"

typedef enum SpringKind { STRUCTURAL, SHEAR, FLEXION, SPRING_KINDS } SpringKind;
extern const char* const spring_kind_name[SPRING_KINDS];

/// How the force grows with the stretch l = length / rest (force/springs.c).
typedef enum SpringLaw { LAW_HOOKE, LAW_RUBBER, LAW_TENSION, SPRING_LAWS } SpringLaw;
extern const char* const spring_law_name[SPRING_LAWS];

typedef struct Springs {
    SpringLaw law;
    int count;
    int from[SPRING_KINDS + 1]; ///< kind k is springs from[k] … from[k + 1] - 1
    int (*end)[2];              ///< [count] particles
    real* stiffness;            ///< [count] [N/m]
    real* rest;                 ///< [count] rest length [m], greater than 0
    real* active;               ///< [count] the stiffness that acts in this step: 0 for a spring
                                ///< that strain limiting has put to rest, else its stiffness
    double bound;               ///< largest (S_i/m_i + S_j/m_j) over the springs [1/s^2], S the sum
                                ///< of attached stiffness: no mode is faster, however deformed
} Springs;

/// Paths of two edges that a mesh may have with flexion springs or torsion, which join the ends of
/// each: those of the largest file of valence 6. A vertex of valence n has n (n - 1) / 2.
enum { SPRING_PATHS_MAX = 1 << 25 };

/// The number of paths of two edges, an upper bound of the flexion springs; `vertex` is the point of
/// most edges.
double springs_paths(const Mesh* mesh, int* vertex);

/// The pairs of the kinds that are wanted, kind after kind. `end` is allocated.
void springs_find(const Mesh* mesh, const bool wanted[SPRING_KINDS], Springs* springs);

void springs_free(Springs* springs);

#endif
