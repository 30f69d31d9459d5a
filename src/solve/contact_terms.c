#include "solve/contact_terms.h"

#include "solve/group.h"

/// k times the contact's compliance, the sum of w^2 / (n.D n) over its nodes with D the blocks of
/// A's diagonal. A larger k needs fewer updates of L. Terms within the bodies' matrices are known to
/// the preconditioner; the others slow the conjugate gradients down as their k grows. A tangential k
/// as large as the normal one would let friction change between sticking and sliding within changes
/// of velocity that matter to nothing. [1]
static const real stiffness_inside = 100, stiffness_apart = 20, stiffness_across = 1;

static real4* entry(const Group* group, const TermNode* node, GroupVector vector) {
    return node->body != NONE ? &group->body[node->body].vector[vector][node->row]
                              : &group->ball[node->ball].vector[vector][0];
}

static bool moves(const TermNode* node) {
    return node->body != NONE || node->ball != NONE;
}

/// Which couplings the matrices have. Those of nodes on both sides of a contact are left out even
/// where the matrix has a block: the smoother converges for stencils of at most three nodes.
static void find_couplings(const Group* group, ContactTerm* term) {
    const Contact* c = term->contact;
    term->apart = c->lever_count > 0;
    for (int a = 0; a < c->node_count; a++) {
        TermNode* node = &term->node[a];
        node->apart = 0;
        for (int b = 0; moves(node) && b < c->node_count; b++) {
            const TermNode* other = &term->node[b];
            if (!moves(other) ||
                (node->body != NONE && node->body == other->body &&
                 c->node[a].weight * c->node[b].weight > 0 &&
                 block_matrix_find(group->body[node->body].matrix, node->row, other->row) >= 0))
                continue;
            node->apart |= 1U << b;
            term->apart = true;
        }
    }
}

static void choose_stiffness(const Group* group, ContactTerm* term) {
    const Contact* c = term->contact;
    real compliance = 0;
    for (int k = 0; k < c->node_count; k++) {
        const TermNode* node = &term->node[k];
        if (!moves(node))
            continue;
        real inertia = c->node[k].mass; // n.D n may be less, or not positive, where a skin folds
        if (node->body != NONE)
            inertia = real_max(
                inertia,
                dot(c->normal,
                    block_times(block_matrix_diagonal(group->body[node->body].matrix, node->row),
                                c->normal)));
        compliance += c->node[k].weight * c->node[k].weight / inertia;
    }
    term->stiffness = (term->apart ? stiffness_apart : stiffness_inside) / compliance;
    term->tangent_stiffness = stiffness_across / compliance * c->tangent_mass / c->normal_mass;
}

/// to += s (1 - n n^T)
static void add_across(Block* to, real s, real4 n) {
    for (int c = 0; c < 3; c++) {
        to->column[c] -= s * n[c] * n;
        to->column[c][c] += s;
    }
}

/// to += s a a^T
static void add_square(Block* to, real s, real4 a) {
    for (int c = 0; c < 3; c++)
        to->column[c] += s * a[c] * a;
}

/// P of the contact at the present velocities, in its impulses, and H.
static void evaluate(ContactTerm* term) {
    Contact* c = term->contact;
    const real4 u = contact_relative_velocity(c);
    const real along = dot(c->normal, u);
    term->tangent = (Block){0};
    c->normal_impulse =
        real_max(0, term->multiplier - term->stiffness * (along - c->min_separation_speed));
    c->tangent_impulse = (real4){0, 0, 0, 0};
    term->active = c->normal_impulse > 0;
    if (!term->active)
        return;
    add_square(&term->tangent, term->stiffness, c->normal);
    if (!(c->friction > 0))
        return;

    const real4 stick =
        term->tangent_multiplier - term->tangent_stiffness * (u - along * c->normal);
    const real size = length(stick), bound = c->friction * term->multiplier;
    if (size <= bound) {
        c->tangent_impulse = stick;
        add_across(&term->tangent, term->tangent_stiffness, c->normal);
    } else {
        const real4 direction = stick / size;
        const real slope = term->tangent_stiffness * bound / size;
        c->tangent_impulse = bound * direction;
        add_across(&term->tangent, slope, c->normal);
        add_square(&term->tangent, -slope, direction);
    }
}

/// Subtract J^T impulse from the residual.
static void subtract_impulse(Group* group, const ContactTerm* term, real4 impulse) {
    const Contact* c = term->contact;
    for (int k = 0; k < c->node_count; k++)
        if (moves(&term->node[k]))
            *entry(group, &term->node[k], GROUP_RESIDUAL) -= c->node[k].weight * impulse;
    for (int k = 0; c->has_couple && k < c->node_count; k++)
        if (moves(&term->node[k]))
            *entry(group, &term->node[k], GROUP_RESIDUAL) -=
                c->node[k].mass * contact_couple_velocity(c, impulse, k);
    for (int k = 0; k < c->lever_count; k++)
        entry(group, &term->node[k], GROUP_RESIDUAL)[1] -= cross(c->lever[k].arm, impulse);
}

static real4 impulse_of(const Contact* c) {
    return c->normal_impulse * c->normal + c->tangent_impulse;
}

void contact_terms_add_impulses(Group* group) {
    for (int t = 0; t < group->term_count; t++) {
        ContactTerm* term = &group->term[t];
        evaluate(term);
        if (term->active)
            subtract_impulse(group, term, impulse_of(term->contact));
    }
}

void contact_terms_evaluate(Group* group) {
    for (int t = 0; t < group->term_count; t++)
        evaluate(&group->term[t]);
}

/// P and H anew, and P's change in the residual.
static void evaluate_again(Group* group, ContactTerm* term) {
    const real4 before = impulse_of(term->contact);
    evaluate(term);
    subtract_impulse(group, term, impulse_of(term->contact) - before);
}

void contact_terms_begin(Group* group) {
    for (int t = 0; t < group->term_count; t++) {
        ContactTerm* term = &group->term[t];
        find_couplings(group, term);
        choose_stiffness(group, term);
        evaluate_again(group, term);
    }
}

void contact_terms_update_multipliers(Group* group) {
    for (int t = 0; t < group->term_count; t++) {
        ContactTerm* term = &group->term[t];
        term->multiplier = term->contact->normal_impulse;
        term->tangent_multiplier = term->contact->tangent_impulse;
        evaluate_again(group, term);
    }
}

void contact_terms_undo_update(Group* group) {
    for (int t = 0; t < group->term_count; t++) {
        const ContactTerm* term = &group->term[t];
        term->contact->normal_impulse = term->multiplier;
        term->contact->tangent_impulse = term->tangent_multiplier;
    }
}

/// Add J^T H J of the couplings within bodies to the bodies' matrices.
static void assemble_term(Group* group, const ContactTerm* term) {
    const Contact* c = term->contact;
    for (int a = 0; a < c->node_count; a++) {
        const TermNode* node = &term->node[a];
        if (node->body == NONE)
            continue;
        const BlockMatrix* matrix = group->body[node->body].matrix;
        for (int b = 0; b < c->node_count; b++) {
            const TermNode* other = &term->node[b];
            if (other->body != node->body || (node->apart >> b & 1 && a != b))
                continue;
            Block* block =
                &matrix->value[a == b ? matrix->from[node->row]
                                      : block_matrix_find(matrix, node->row, other->row)];
            for (int k = 0; k < 3; k++)
                block->column[k] +=
                    (c->node[a].weight * c->node[b].weight) * term->tangent.column[k];
        }
    }
}

/// Inverse of the symmetric matrix of columns a, b, c.
static void invert(const double4 a[3], double4 inverse[3]) {
    const double4 across = dcross(a[1], a[2]);
    const double determinant = ddot(a[0], across);
    inverse[0] = across / determinant;
    inverse[1] = dcross(a[2], a[0]) / determinant;
    inverse[2] = dcross(a[0], a[1]) / determinant;
}

static void assemble_ball(const Group* group, int number) {
    GroupBall* ball = &group->ball[number];
    const double mass = (double)ball->sphere->mass;
    double4 block[3] = {{mass, 0, 0, 0}, {0, mass, 0, 0}, {0, 0, mass, 0}};
    double spin = (double)sphere_inertia(ball->sphere);
    for (int t = 0; t < group->term_count; t++) {
        const ContactTerm* term = &group->term[t];
        for (int k = 0; term->active && k < term->contact->lever_count; k++) {
            if (term->node[k].ball != number)
                continue;
            const real4 arm = term->contact->lever[k].arm;
            const real4* column = term->tangent.column;
            for (int c = 0; c < 3; c++)
                block[c] += to_double4(column[c]);
            spin += (double)(dot(arm, arm) *
                             (column[0][0] + column[1][1] + column[2][2] - term->stiffness));
        }
    }
    joint_terms_add_block(group, number, block);
    invert(block, ball->inverse);
    ball->inverse_spin = 1 / spin;
}

void contact_terms_assemble(Group* group) {
    for (int t = 0; t < group->term_count; t++)
        if (group->term[t].active)
            assemble_term(group, &group->term[t]);
    for (int s = 0; s < group->ball_count; s++)
        assemble_ball(group, s);
}

double contact_terms_noise(const Group* group) {
    double noise = 0;
    for (int s = 0; s < group->ball_count; s++) {
        const Sphere* ball = group->ball[s].sphere;
        noise += (double)(ball->mass * dot(ball->v, ball->v));
    }
    for (int t = 0; t < group->term_count; t++) {
        const ContactTerm* term = &group->term[t];
        const Contact* c = term->contact;
        double speed2 = 0;
        for (int k = 0; term->active && k < c->node_count; k++) {
            const real4 v = c->node[k].weight * *c->node[k].velocity;
            speed2 += (double)dot(v, v);
        }
        const double k2 =
            (double)(term->stiffness * term->stiffness / c->normal_mass +
                     term->tangent_stiffness * term->tangent_stiffness / c->tangent_mass);
        noise += c->node_count * speed2 * k2; // each addition to u rounds anew
    }
    return noise;
}

double contact_terms_precondition(Group* group) {
    double squared = 0;
    for (int k = 0; k < group->ball_count; k++) {
        GroupBall* ball = &group->ball[k];
        const real4* r = ball->vector[GROUP_REMAINDER];
        real4* z = ball->vector[GROUP_PRECONDITIONED];
        z[0] = to_real4((double)r[0][0] * ball->inverse[0] + (double)r[0][1] * ball->inverse[1] +
                        (double)r[0][2] * ball->inverse[2]);
        z[1] = (real)ball->inverse_spin * r[1];
        squared += (double)(dot(r[0], z[0]) + dot(r[1], z[1]));
    }
    return squared;
}

/// The couplings that no matrix has: image_a += w_a H (sum of w_b p_b over those b, and the spins).
static void multiply_term(Group* group, const ContactTerm* term) {
    const Contact* c = term->contact;
    real4 part[CONTACT_NODES], spin = {0, 0, 0, 0}, all;
    for (int k = 0; k < c->lever_count; k++)
        spin += cross(entry(group, &term->node[k], GROUP_DIRECTION)[1], c->lever[k].arm);
    all = spin;
    for (int k = 0; k < c->node_count; k++) {
        part[k] = (real4){0, 0, 0, 0};
        if (moves(&term->node[k]))
            part[k] = c->node[k].weight * *entry(group, &term->node[k], GROUP_DIRECTION);
        all += part[k];
    }
    for (int a = 0; a < c->node_count; a++) {
        const TermNode* node = &term->node[a];
        if (!moves(node))
            continue;
        real4 sum = spin;
        for (int b = 0; b < c->node_count; b++)
            if (node->apart >> b & 1)
                sum += part[b];
        *entry(group, node, GROUP_IMAGE) += c->node[a].weight * block_times(&term->tangent, sum);
    }
    for (int k = 0; k < c->lever_count; k++)
        entry(group, &term->node[k], GROUP_IMAGE)[1] +=
            cross(c->lever[k].arm, block_times(&term->tangent, all));
}

void contact_terms_multiply(Group* group) {
    for (int s = 0; s < group->ball_count; s++) {
        GroupBall* ball = &group->ball[s];
        const real4* p = ball->vector[GROUP_DIRECTION];
        ball->vector[GROUP_IMAGE][0] = ball->sphere->mass * p[0];
        ball->vector[GROUP_IMAGE][1] = sphere_inertia(ball->sphere) * p[1];
    }
    for (int t = 0; t < group->term_count; t++)
        if (group->term[t].active && group->term[t].apart)
            multiply_term(group, &group->term[t]);
}

double contact_terms_potential(const Group* group) {
    double sum = 0;
    for (int s = 0; s < group->ball_count; s++) {
        const GroupBall* ball = &group->ball[s];
        const real4 dv = ball->sphere->v - ball->v_start,
                    spin = ball->sphere->spin - ball->spin_start;
        sum += (double)(ball->sphere->mass * dot(dv, dv) +
                        sphere_inertia(ball->sphere) * dot(spin, spin)) /
               2;
    }
    for (int t = 0; t < group->term_count; t++) {
        const ContactTerm* term = &group->term[t];
        const Contact* c = term->contact;
        if (!term->active)
            continue;
        const double normal = (double)c->normal_impulse;
        sum += normal * normal / (2 * (double)term->stiffness);
        if (!(c->friction > 0))
            continue;
        const real4 u = contact_relative_velocity(c);
        const real4 stick = term->tangent_multiplier -
                            term->tangent_stiffness * (u - dot(c->normal, u) * c->normal);
        const double size = (double)length(stick);
        const double bound = fmin(size, (double)(c->friction * term->multiplier));
        sum += bound * (size - bound / 2) / (double)term->tangent_stiffness;
    }
    return sum;
}
