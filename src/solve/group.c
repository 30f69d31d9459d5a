#include "solve/group.h"

#include <stdlib.h>

#include "base/memory.h"
#include "mesh/counting_sort.h"
#include "solve/system.h"

static void reserve(Groups* groups, int sides, int terms) {
    if (sides > groups->side_capacity) {
        const Groups before = *groups;
        groups->term = NULL;
        groups->joint = NULL;
        groups->knot_location = NULL;
        groups_close(groups);
        *groups = (Groups){
            .group = new_array(Group, sides),
            .body = new_array(GroupBody, sides),
            .ball = new_array(GroupBall, sides),
            .term = before.term,
            .joint = before.joint,
            .knot_location = before.knot_location,
            .joint_capacity = before.joint_capacity,
            .side_capacity = sides,
            .term_capacity = before.term_capacity,
            .group_of = new_array(int, sides),
            .group_of_island = new_array(int, sides),
            .from = new_array(int, sides + 1),
            .item = new_array(int, sides),
            .location = new_array(int, sides),
        };
    }
    if (terms > groups->term_capacity) {
        free(groups->term);
        groups->term_capacity = 2 * terms;
        groups->term = new_array(ContactTerm, 2 * terms);
    }
}

static bool has_islands(const System* system, const Contacts* contacts) {
    return contacts->contact_count > 0 || system->joints.count > 0;
}

/// A new group; its terms are the island's contacts.
static int add_group(Groups* groups, const Contacts* contacts, int island) {
    Group* group = &groups->group[groups->count];
    *group = (Group){0};
    if (island != NONE) {
        const int* start = &contacts->islands.start[island];
        group->term_count = start[1] - start[0];
        if (group->term_count > 0) // bodies that only strings join have no list of contacts
            group->term = groups->term + start[0];
        groups->group_of_island[island] = groups->count;
    }
    return groups->count++;
}

/// The group of each side: awake bodies in ascending order begin one, or join that of their island.
static void number_groups(Groups* groups, const System* system, const Contacts* contacts) {
    const int spheres = contacts->sphere_count;
    const Islands* islands = has_islands(system, contacts) ? &contacts->islands : NULL;
    groups->count = 0;
    for (int i = 0; islands && i < islands->count; i++)
        groups->group_of_island[i] = NONE;
    for (int b = 0; b < system->body_count; b++) {
        const int island = islands ? islands_of_side(islands, spheres + b) : NONE;
        int* number = &groups->group_of[spheres + b];
        *number = NONE;
        if (system->body[b]->asleep)
            continue;
        if (island != NONE)
            *number = groups->group_of_island[island];
        if (*number == NONE)
            *number = add_group(groups, contacts, island);
    }
    for (int s = 0; s < spheres; s++) {
        const int island = islands ? islands_of_side(islands, s) : NONE;
        groups->group_of[s] = island == NONE ? NONE : groups->group_of_island[island];
    }
}

static void collect_sides(Groups* groups, System* system, Contacts* contacts) {
    const int spheres = contacts->sphere_count;
    GroupBody* body = groups->body;
    GroupBall* ball = groups->ball;
    counting_sort(groups->group_of, spheres + system->body_count, groups->count, groups->from,
                  groups->item);
    for (int g = 0; g < groups->count; g++) {
        Group* group = &groups->group[g];
        group->body = body;
        group->ball = ball;
        for (int k = groups->from[g]; k < groups->from[g + 1]; k++) {
            const int side = groups->item[k], b = side - spheres;
            if (side < spheres) {
                Sphere* sphere = &contacts->sphere[side];
                groups->location[side] = group->ball_count++;
                *ball++ =
                    (GroupBall){.sphere = sphere, .v_start = sphere->v, .spin_start = sphere->spin};
            } else {
                groups->location[side] = group->body_count++;
                *body++ = (GroupBody){.body = system->body[b],
                                      .number = b,
                                      .workspace = system->workspace[b],
                                      .stats = system->stats[b]};
            }
        }
        ball += joint_terms_add_knots(groups, &system->joints, spheres, g, ball);
    }
}

/// The node of a contact, on one of its two sides.
static TermNode find_node(const Groups* groups, const Contacts* contacts, const Contact* contact,
                          int k) {
    const ContactNode* node = &contact->node[k];
    TermNode found = {NONE, NONE, 0, 0};
    for (int s = 0; s < 2; s++) {
        const int side = contact->side[s];
        if (side == NONE || side >= contacts->sphere_count + contacts->first_thing ||
            groups->group_of[side] == NONE || node->response == 0)
            continue;
        if (side < contacts->sphere_count) {
            if (node->velocity == &contacts->sphere[side].v)
                found.ball = groups->location[side];
            continue;
        }
        const Body* body = contacts->skin[side - contacts->sphere_count].body;
        if (node->velocity < body->v || node->velocity >= body->v + body->count)
            continue;
        found.body = groups->location[side];
        found.row = (int)(node->velocity - body->v);
    }
    return found;
}

static void make_terms(Groups* groups, const Contacts* contacts) {
    const Islands* islands = &contacts->islands;
    for (int t = 0; t < contacts->contact_count; t++) {
        Contact* contact = islands->contact[t];
        ContactTerm* term = &groups->term[t];
        *term = (ContactTerm){.contact = contact,
                              .multiplier = contact->normal_impulse,
                              .tangent_multiplier = contact->tangent_impulse};
        for (int k = 0; k < contact->node_count; k++)
            term->node[k] = find_node(groups, contacts, contact, k);
    }
}

void groups_open(Groups* groups, int body_count) {
    *groups = (Groups){0};
    reserve(groups, body_count, 0);
}

void groups_find(Groups* groups, System* system, Contacts* contacts) {
    const int sides = contacts->sphere_count + system->body_count;
    const Joints* joints = &system->joints;
    reserve(groups, sides + joints->knot_count, contacts->contact_count);
    joint_terms_reserve(groups, joints);
    if (has_islands(system, contacts))
        islands_find_joined(&contacts->islands, contacts->contact, contacts->contact_count, sides,
                            joints->joined, system->body_count);
    number_groups(groups, system, contacts);
    collect_sides(groups, system, contacts);
    joint_terms_find(groups, joints, contacts->sphere_count);
    make_terms(groups, contacts);
}

void group_forget_contacts(Group* group) {
    for (int t = 0; t < group->term_count; t++) {
        group->term[t].contact->normal_impulse = 0;
        group->term[t].contact->tangent_impulse = (real4){0, 0, 0, 0};
    }
    group->term_count = 0;
}

void groups_close(Groups* groups) {
    free(groups->group);
    free(groups->body);
    free(groups->ball);
    free(groups->term);
    free(groups->joint);
    free(groups->knot_location);
    free(groups->group_of);
    free(groups->group_of_island);
    free(groups->from);
    free(groups->item);
    free(groups->location);
    *groups = (Groups){0};
}
