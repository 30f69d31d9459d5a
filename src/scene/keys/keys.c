/// The keys of a scene outside its balloons (keys_balloon.c).
#include "scene/key.h"

#include <math.h>

#include "solve/method.h"

const char* const guard_name[GUARD_COUNT] = {"split", "stop", "off"};
const char* const units_name[UNITS_COUNT] = {"si", "paper"};
const char* const precision_name[PRECISIONS] = {"any", "float", "double"};

#define AT(field) .offset = offsetof(DEF, field)
#define COUNT(field) .count_offset = offsetof(DEF, field)
#define GROUP(rows, Def)                                                                           \
    { .key = rows, .count = sizeof rows / sizeof rows[0], .size = sizeof(Def) }

#define RUBBER_FRICTION 0.8 // of rubber on a dry floor

// clang-format off
#define DEF CameraDef
static const Key camera_row[] = {
    {{"eye",  "m", ANY, NAN, "where the eye is"},      KEY_VECTOR, AT(eye),  .required = true},
    {{"look", "m", ANY, NAN, "the point that it looks at"}, KEY_VECTOR, AT(look), .required = true},
};
#undef DEF
static const KeyGroup camera_keys = GROUP(camera_row, CameraDef);

#define DEF AboutDef
static const Key about_row[] = {
    {{"output", NO_NUMBER, "a column of the CSV"}, KEY_TEXT, AT(output), .longest = WORD_LONGEST},
    {{"at", "s", NOT_NEGATIVE, 0, "time at which the output is compared"}, KEY_NUMBER, AT(at)},
    {{"tolerance", "1", POSITIVE, NAN, "largest error, relative to the output's size; required with "
      "`output`"}, KEY_NUMBER, AT(tolerance), .absent = "none"},
    {{"none", NO_NUMBER, "instead of outputs, in one item: why no output can be held to a number"}, KEY_TEXT,
     AT(none), .longest = TEXT_LONGEST},
};
#undef DEF
static const KeyGroup about_keys = GROUP(about_row, AboutDef);

#define DEF BecauseDef
static const Key because_row[] = {
    {{"part", NO_NUMBER, "a part's name in `balloon needs`"}, KEY_TEXT, AT(part), .required = true,
     .longest = WORD_LONGEST},
    {{"reason", NO_NUMBER, "why the part stays"}, KEY_TEXT, AT(reason), .required = true,
     .longest = TEXT_LONGEST},
};
#undef DEF
static const KeyGroup because_keys = GROUP(because_row, BecauseDef);

#define DEF FailsDef
static const Key fails_row[] = {
    {{"at", "s", POSITIVE, NAN, "by when the scene has failed"}, KEY_NUMBER, AT(at), .required = true},
    {{"halts", NO_NUMBER, "the state goes bad and is caught"}, KEY_FLAG, AT(halts)},
    {{"output", NO_NUMBER, "without `halts`: a column of the CSV, on the wrong side of a limit"}, KEY_TEXT,
     AT(output), .longest = WORD_LONGEST},
    {{"above", "of the output", ANY, NAN, "limit above which it fails"}, KEY_OPTIONAL, AT(above)},
    {{"below", "of the output", ANY, NAN, "limit below which it fails; one of the two"}, KEY_OPTIONAL, AT(below)},
    {{"truth", "of the output", ANY, NAN, "the right value"}, KEY_OPTIONAL, AT(truth)},
    {{"cure", NO_NUMBER, "overrides, KEY=VALUE, with which the scene does not fail"}, KEY_TEXTS,
     AT(cure), COUNT(cure_count), .longest = TEXT_LONGEST},
};
#undef DEF
static const KeyGroup fails_keys = GROUP(fails_row, FailsDef);

#define DEF SphereDef
static const Key sphere_row[] = {
    {{"position", "m", ANY, NAN, "center at the start"}, KEY_VECTOR, AT(position), .required = true},
    {{"velocity", "m/s", ANY, NAN, "velocity at the start"}, KEY_VECTOR, AT(velocity),
     .absent = "at rest"},
    {{"radius", "m", POSITIVE, NAN, "radius"}, KEY_NUMBER, AT(radius), .required = true},
    {{"mass", "kg", POSITIVE, NAN, "mass"}, KEY_NUMBER, AT(mass), .required = true},
    {{"restitution", "1", 0, 1, false, false, false, 0, "Newton's coefficient"}, KEY_NUMBER, AT(restitution)},
    {{"friction", "1", NOT_NEGATIVE, 0, "Coulomb's coefficient against skins, floor, walls and, as the geometric mean of both, balls"}, KEY_NUMBER, AT(friction)},
};
#undef DEF
static const KeyGroup sphere_keys = GROUP(sphere_row, SphereDef);

#define DEF WallDef
static const Key wall_row[] = {
    {{"at", "m", ANY, NAN, "a point of the wall"}, KEY_VECTOR, AT(at), .required = true},
    {{"normal", "1", ANY, NAN, "direction to the side of the balloons, of any length but 0"}, KEY_VECTOR,
     AT(normal), .required = true},
    {{"friction", "1", NOT_NEGATIVE, RUBBER_FRICTION, "Coulomb's coefficient of skins on it"}, KEY_NUMBER, AT(friction)},
};
#undef DEF
static const KeyGroup wall_keys = GROUP(wall_row, WallDef);

#define DEF PathPointDef
static const Key path_row[] = {
    {{"at", "s", NOT_NEGATIVE, 0, "time"}, KEY_NUMBER, AT(at)},
    {{"position", "m", ANY, NAN, "where the thing or the knot is then"}, KEY_VECTOR, AT(position), .required = true},
    {{"rotation", "degrees", ANY, NAN, "of a thing: about the axes x, then y, then z, after its own rotation; 720 are two turns"},
     KEY_VECTOR, AT(rotation), .absent = "none"},
};
#undef DEF
static const KeyGroup path_keys = GROUP(path_row, PathPointDef);

#define DEF ThingDef
static const Key thing_row[] = {
    {{"model", NO_NUMBER, "a shape, as box or capsule, or a mesh file beside the scene or in assets/models"}, KEY_TEXT,
     AT(model), .required = true, .longest = TEXT_LONGEST},
    {{"position", "m", ANY, NAN, "added to the model's points"}, KEY_VECTOR, AT(position),
     .absent = "the origin, or the path's"},
    {{"size", "m", POSITIVE, NAN, "sides of the model's bounding box, whose middle is then its origin; a capsule keeps round ends"},
     KEY_VECTOR, AT(size), .absent = "the model's own"},
    {{"scale", "1", POSITIVE, 1, "factor on the model's points"}, KEY_NUMBER, AT(scale)},
    {{"rotation", "degrees", ANY, NAN, "about the axes x, then y, then z"}, KEY_VECTOR, AT(rotation),
     .absent = "none", .old = "turn"},
    {{"color", "1", 0, 1, false, false, false, NAN, "red, green and blue in sRGB"}, KEY_VECTOR, AT(color),
     .absent = "gray"},
    {{"friction", "1", NOT_NEGATIVE, RUBBER_FRICTION, "Coulomb's coefficient of skins on it; a ball has its own"}, KEY_NUMBER, AT(friction)},
    {{"path", NO_NUMBER, "points that the thing goes through in straight lines and turns, no point of it faster than 50 m/s"}, KEY_LIST, AT(path), COUNT(path_count),
     .group = &path_keys},
};
#undef DEF
static const KeyGroup thing_keys = GROUP(thing_row, ThingDef);

#define DEF KnotDef
static const Key knot_row[] = {
    {{"position", "m", ANY, NAN, "where it is at the start"}, KEY_VECTOR, AT(position),
     .absent = "required without `path`"},
    {{"mass", "kg", NOT_NEGATIVE, 0, "mass; 0: the knot is held"}, KEY_NUMBER, AT(mass)},
    {{"path", NO_NUMBER, "points that a held knot goes through in straight lines, at most 50 m/s"}, KEY_LIST, AT(path), COUNT(path_count),
     .group = &path_keys},
};
#undef DEF
static const KeyGroup knot_keys = GROUP(knot_row, KnotDef);

#define DEF PipeDef
static const Key pipe_row[] = {
    {{"from", "1", NOT_NEGATIVE, NAN, "number of a balloon with gas, from 0"}, KEY_NUMBER, AT(from), .required = true},
    {{"to", "1", NOT_NEGATIVE, NAN, "number of another"}, KEY_NUMBER, AT(to), .required = true},
    {{"conductance", "m^3/s", POSITIVE, NAN, "p V that flows per second and pascal of pressure difference"},
     KEY_NUMBER, AT(conductance), .required = true},
    {{"start", "s", NOT_NEGATIVE, 0, "when the pipe is opened"}, KEY_NUMBER, AT(start)},
};
#undef DEF
static const KeyGroup pipe_keys = GROUP(pipe_row, PipeDef);

#define DEF SolverDef
static const Key solver_row[] = {
    {{"iterations", "1", 0, 10000, false, false, false, 0, "largest number for each step"}, KEY_NUMBER,
     AT(iterations), .absent = "0: the method's own number"},
    {{"tolerance", "1", 0, 1, false, false, false, 0, "relative residual at which a step is solved"},
     KEY_NUMBER, AT(tolerance), .absent = "0: the method's own"},
    {{"linear_tolerance", "1", 0, 1, false, false, false, 0, "relative residual at which each of its linear systems is solved"}, KEY_NUMBER,
     AT(linear_tolerance), .absent = "0: the method's own"},
    {{"fixed", NO_NUMBER, "make all iterations, whatever the residual"}, KEY_FLAG, AT(fixed)},
    {{"start", NO_NUMBER, "where the iterations of a step begin"}, KEY_NAME, AT(start),
     .name = step_start_name, .name_count = STEP_STARTS},
    {{"in_place", NO_NUMBER, "`euler` moves each particle before it computes the next one's force"},
     KEY_FLAG, AT(in_place)},
    {{"paper_tangent", NO_NUMBER, "take the gas's stiffness of the thin-shell paper, a third of the "
      "exact one"}, KEY_FLAG, AT(paper_tangent)},
};
#undef DEF
static const KeyGroup solver_keys = GROUP(solver_row, SolverDef);

#define DEF SkinContacts
static const Key contacts_row[] = {
    {{"self", NO_NUMBER, "a skin touches itself"}, KEY_FLAG, AT(self)},
    {{"others", NO_NUMBER, "two skins touch each other"}, KEY_FLAG, AT(others)},
    {{"friction", "1", NOT_NEGATIVE, RUBBER_FRICTION, "Coulomb's coefficient between skins"}, KEY_NUMBER, AT(friction)},
};
#undef DEF
static const KeyGroup contacts_keys = GROUP(contacts_row, SkinContacts);

#define DEF WorldDef
#define LIST(field, keys) KEY_LIST, AT(field), COUNT(field##_count), .group = &keys
static const Key world_row[] = {
    {{"title", NO_NUMBER, "one line for lists"}, KEY_TEXT, AT(title), .longest = TEXT_LONGEST},
    {{"units", NO_NUMBER, "SI, or the mass-spring paper's, whose numbers have no SI unit"}, KEY_NAME,
     AT(units), .name = units_name, .name_count = UNITS_COUNT},
    {{"step", "s", 0, 1, true, false, false, NAN, "length of the fixed step"}, KEY_NUMBER, AT(step),
     .required = true},
    {{"gravity", "m/s^2", ANY, NAN, "acceleration downward"}, KEY_OPTIONAL, AT(gravity),
     .absent = "9.81, or 9.8 in the paper's units"},
    {{"floor", "m", ANY, NAN, "height of the floor"}, KEY_OPTIONAL, AT(floor), .absent = "no floor"},
    {{"floor_friction", "1", NOT_NEGATIVE, RUBBER_FRICTION, "Coulomb's coefficient of skins on the floor; a ball has its own"}, KEY_NUMBER, AT(floor_friction)},
    {{"guard", NO_NUMBER, "what to do with a step above the stability bound"}, KEY_NAME, AT(guard),
     .name = guard_name, .name_count = GUARD_COUNT},
    {{"precision", NO_NUMBER, "number type of the state; `any`: that of the program, float for balloon"}, KEY_NAME, AT(precision), .name = precision_name,
     .name_count = PRECISIONS},
    {{"method", NO_NUMBER, "method of the steps"}, KEY_TEXT, AT(method),
     .absent = "`euler`", .longest = WORD_LONGEST, .table = method_table,
     .table_count = &method_count},
    {{"solver", NO_NUMBER, "how a method solves its steps"}, KEY_MAPPING, AT(solver),
     .group = &solver_keys},
    {{"show", NO_NUMBER, "the display mode at the start: one of `balloon list`"}, KEY_TEXT, AT(show),
     .absent = "`skin`", .longest = WORD_LONGEST},
    {{"sleep_threshold", "1/s", 0, 1, false, false, false, 0, "a balloon sleeps once each of its particles has been slower than "
      "this many of its sizes a second for half a second; 0: none sleeps"}, KEY_NUMBER, AT(sleep_threshold),
     .old = "rest"},
    {{"seconds", "s", POSITIVE, 10, "how long headless runs last"}, KEY_NUMBER, AT(seconds)},
    {{"camera", NO_NUMBER, "where the eye is"}, KEY_POINTER, AT(camera), .group = &camera_keys,
     .absent = "the whole scene is in sight"},
    {{"about", NO_NUMBER, "the outputs that the scene is for; `balloon needs` judges by them"}, LIST(about, about_keys)},
    {{"because", NO_NUMBER, "why parts stay that the outputs do not need"}, LIST(because, because_keys)},
    {{"fails", NO_NUMBER, "what goes wrong in a scene of the museum of failures"}, KEY_POINTER,
     AT(fails), .group = &fails_keys},
    {{"contact", NO_NUMBER, "impulses that keep momentum, or the mass-spring paper's penalty"},
     KEY_NAME, AT(contact), .name = contact_law_name, .name_count = CONTACT_LAWS},
    {{"contacts", NO_NUMBER, "which skins touch, and how; one that does is never crossed"}, KEY_MAPPING, AT(contacts),
     .group = &contacts_keys},
    {{"spheres", NO_NUMBER, "balls that are there from the start"}, LIST(spheres, sphere_keys)},
    {{"walls", NO_NUMBER, "half-spaces beside the floor"}, LIST(walls, wall_keys)},
    {{"things", NO_NUMBER, "obstacles of infinite mass, at rest or on a path"}, LIST(things, thing_keys)},
    {{"knots", NO_NUMBER, "points that strings share"}, LIST(knots, knot_keys)},
    {{"pipes", NO_NUMBER, "gas flows through each to the lower pressure"}, LIST(pipes, pipe_keys)},
    {{"balloons", NO_NUMBER, "the balloons"}, LIST(balloons, balloon_keys), .required = true,
     .shortest = 1},
};
#undef DEF
// clang-format on

const KeyGroup scene_keys = GROUP(world_row, WorldDef);
