/// Contacts as terms of an implicit step's equation, by an augmented Lagrangian.
///
///     M (v' - v) - h f(x + h v', v') - sum of J^T P = 0
///     P_n = max(0, L_n - k (n.u' - s))          normal impulse
///     P_t = L_t - k_t u_t', no longer than friction L_n      tangent impulse
///
/// J maps the nodes' velocities to the relative velocity u of contact.h, s is the contact's lower
/// bound of n.u', L is a multiplier that is set to P between the iterations, so that in the end
/// n.u' = s wherever P_n > 0, for any k. P has the symmetric positive tangent
///
///     H = -dP/du = k n n^T + k_t (1 - n n^T)             where it sticks
///                  k n n^T + k_t |P_t|/|d| (1 - n n^T - d d^T/|d|^2),  d = L_t - k_t u_t, sliding
///
/// J contains the couple of contact.h; H, that of an approximate Newton's method, leaves it out.
/// J^T H J joins the tangent: the blocks of nodes of one body that the body's matrix has, in that
/// matrix, and so in the preconditioner's levels; the others are multiplied contact after contact.
/// Equal and opposite impulses along one line keep momenta as in contact.h. Sources: P. Alart, A.
/// Curnier, A mixed formulation for frictional contact problems prone to Newton like solution
/// methods, 1991; J. Simo, T. Laursen, An augmented Lagrangian treatment of contact problems
/// involving friction, 1992.
#ifndef BALLOON_SOLVE_CONTACT_TERMS_H
#define BALLOON_SOLVE_CONTACT_TERMS_H

#include "body/body.h"
#include "contact/contact.h"
#include "contact/sphere.h"
#include "force/block_matrix.h"

/// Vectors of an equation over all bodies and balls of a group.
typedef enum GroupVector {
    GROUP_RESIDUAL,  ///< R
    GROUP_CHANGE,    ///< dv
    GROUP_REMAINDER, ///< r = -R - A dv
    GROUP_PRECONDITIONED,
    GROUP_DIRECTION,
    GROUP_IMAGE,
    GROUP_VECTORS
} GroupVector;

struct SolveStats;
struct LinearSolve;

typedef struct GroupBody {
    Body* body;
    int number;                   ///< of the system
    void* workspace;              ///< the method's
    struct SolveStats* stats;     ///< the system's
    struct LinearSolve* linear;   ///< the method's
    BlockMatrix* matrix;          ///< its A, without dense parts
    real4* vector[GROUP_VECTORS]; ///< [body->count] each, the method's
} GroupBody;

typedef struct GroupBall {
    Sphere* sphere;
    real4 v_start, spin_start;      ///< after its weight's kick [m/s], [rad/s]
    real4 vector[GROUP_VECTORS][2]; ///< of velocity and of spin
    double4 inverse[3];             ///< inverse of A's diagonal block of the velocity, as columns
    double inverse_spin;            ///< of a bound of the block of the spin
} GroupBall;

/// Where a contact's node is: particle `row` of a body, or a ball; both NONE: it does not move.
typedef struct TermNode {
    int body, ball; ///< of the group
    int row;
    unsigned apart; ///< bit k: the coupling with node k is not in a body's matrix
} TermNode;

typedef struct ContactTerm {
    Contact* contact; ///< its impulses are P
    TermNode node[CONTACT_NODES];
    bool apart;               ///< some couplings are not in a body's matrix
    bool active;              ///< P_n > 0
    real stiffness;           ///< k [kg]; 0 until contact_terms_begin
    real tangent_stiffness;   ///< k_t [kg]
    real multiplier;          ///< L_n [N s]
    real4 tangent_multiplier; ///< L_t [N s]
    Block tangent;            ///< H [kg]
} ContactTerm;

struct Group;

/// Choose k by the diagonals of the bodies' matrices; before, P is the warm start's L. Subtract J^T of
/// P's change from the residual, and compute H.
void contact_terms_begin(struct Group* group);

/// Compute P and H at the present velocities, and subtract J^T P from the residual.
void contact_terms_add_impulses(struct Group* group);

/// Compute P and H at the present velocities.
void contact_terms_evaluate(struct Group* group);

/// Set L to P. Subtract J^T of P's change from the residual, and compute H anew.
void contact_terms_update_multipliers(struct Group* group);

/// Set the contacts' impulses P to what they were before the last update, for which R was computed.
void contact_terms_undo_update(struct Group* group);

/// Add J^T H J to the bodies' matrices, and compute the balls' blocks of the preconditioner.
void contact_terms_assemble(struct Group* group);

/// Sum over balls and contacts of the squared error of R, as |R|^2_(1/M), for velocities that are off by
/// their own size: P is off by k times the error of n.u [kg m^2/s^2].
double contact_terms_noise(const struct Group* group);

/// image += the part of A p that is not in the bodies' matrices; image of the balls.
void contact_terms_multiply(struct Group* group);

/// Balls' rows of z = D^-1 r, of A's diagonal blocks D. Returns their part of r . z.
double contact_terms_precondition(struct Group* group);

/// The contacts' part of the incremental potential [J].
double contact_terms_potential(const struct Group* group);

#endif
