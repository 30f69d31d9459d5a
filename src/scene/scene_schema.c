#include "scene/scene_schema.h"

#include "scene/scene.h"

const char* const guard_name[GUARD_COUNT] = {"split", "stop", "off"};
const char* const units_name[UNITS_COUNT] = {"si", "paper"};
const char* const precision_name[PRECISIONS] = {"any", "float", "double"};

enum {
    MAY = CYAML_FLAG_OPTIONAL,
    MUST = CYAML_FLAG_DEFAULT,
    LIST = CYAML_FLAG_POINTER,
    NAMED = CYAML_FLAG_STRICT, ///< names only, not their numbers
    WORD_MOST = 64,            ///< [bytes] longest name
    TEXT_MOST = 400,           ///< [bytes] longest title and model, so that paths fit their buffers
};

// libcyaml's form of the name tables, filled from them by scene_schema
static cyaml_strval_t units_word[UNITS_COUNT];
static cyaml_strval_t precision_word[PRECISIONS];
static cyaml_strval_t guard_word[GUARD_COUNT];
static cyaml_strval_t spring_law_word[SPRING_LAWS];
static cyaml_strval_t inflation_law_word[INFLATION_LAWS];
static cyaml_strval_t contact_law_word[CONTACT_LAWS];
static cyaml_strval_t volume_rule_word[VOLUME_RULES];
static cyaml_strval_t step_start_word[STEP_STARTS];

#define NUMBER(key, need, Def) CYAML_FIELD_FLOAT(#key, need, Def, key)
#define NUMBER_OR_NULL(key, Def) CYAML_FIELD_FLOAT_PTR(#key, MAY, Def, key)
#define VECTOR(key, need, Def) CYAML_FIELD_SEQUENCE_FIXED(#key, (need) | LIST, Def, key, &number, 3)
#define TEXT(key, need, Def, most) CYAML_FIELD_STRING_PTR(#key, need, Def, key, 1, most)
#define NAME(key, need, Def, words)                                                                \
    CYAML_FIELD_ENUM(#key, (need) | NAMED, Def, key, words, CYAML_ARRAY_LEN(words))
#define YES_NO(key, Def) CYAML_FIELD_BOOL(#key, MAY, Def, key)
#define GROUP(key, need, Def, fields) CYAML_FIELD_MAPPING(#key, need, Def, key, fields)
#define GROUP_OR_NULL(key, Def, fields) CYAML_FIELD_MAPPING_PTR(#key, MAY, Def, key, fields)
#define GROUPS(key, need, Def, group, least)                                                       \
    CYAML_FIELD_SEQUENCE(#key, (need) | LIST, Def, key, group, least, CYAML_UNLIMITED)

static const cyaml_schema_value_t number = {CYAML_VALUE_FLOAT(MUST, double)};

static const cyaml_schema_field_t springs_field[] = {
    NUMBER(structural, MAY, SpringsDef),
    NUMBER(shear, MAY, SpringsDef),
    NUMBER(flexion, MAY, SpringsDef),
    NUMBER(torsion, MAY, SpringsDef),
    NAME(law, MAY, SpringsDef, spring_law_word),
    CYAML_FIELD_END,
};

static const cyaml_schema_field_t patch_field[] = {
    VECTOR(at, MUST, PatchDef),
    NUMBER(radius, MUST, PatchDef),
    NUMBER(thickness, MUST, PatchDef),
    CYAML_FIELD_END,
};
static const cyaml_schema_value_t patch = {CYAML_VALUE_MAPPING(MUST, PatchDef, patch_field)};

static const cyaml_schema_field_t membrane_field[] = {
    TEXT(material, MUST, MembraneDef, WORD_MOST),
    NUMBER(young, MUST, MembraneDef),
    NUMBER_OR_NULL(poisson, MembraneDef),
    NUMBER(mooney, MAY, MembraneDef),
    NUMBER(density, MUST, MembraneDef),
    NUMBER(thickness, MUST, MembraneDef),
    NAME(volume, MAY, MembraneDef, volume_rule_word),
    GROUPS(patches, MAY, MembraneDef, &patch, 0),
    CYAML_FIELD_END,
};

static const cyaml_schema_field_t skin_field[] = {
    GROUP_OR_NULL(springs, SkinDef, springs_field),
    GROUP_OR_NULL(membrane, SkinDef, membrane_field),
    CYAML_FIELD_END,
};

static const cyaml_schema_field_t mass_field[] = {
    NUMBER(per_particle, MUST, MassDef),
    CYAML_FIELD_END,
};

static const cyaml_schema_field_t fill_field[] = {
    NUMBER(to, MUST, FillDef),
    NUMBER(start, MAY, FillDef),
    NUMBER(seconds, MUST, FillDef),
    CYAML_FIELD_END,
};

static const cyaml_schema_field_t inflation_field[] = {
    NAME(law, MUST, InflationDef, inflation_law_word),
    NUMBER(amount, MAY, InflationDef),
    NUMBER(rate, MAY, InflationDef),
    NUMBER(least, MAY, InflationDef),
    NUMBER(most, MAY, InflationDef),
    NUMBER_OR_NULL(ambient, InflationDef),
    NUMBER_OR_NULL(unit, InflationDef),
    NUMBER_OR_NULL(temperature, InflationDef),
    YES_NO(adiabatic, InflationDef),
    TEXT(filling, MAY, InflationDef, WORD_MOST),
    NUMBER(leak, MAY, InflationDef),
    NUMBER(vent, MAY, InflationDef),
    GROUP_OR_NULL(fill, InflationDef, fill_field),
    CYAML_FIELD_END,
};

static const cyaml_schema_field_t helium_field[] = {
    NUMBER(base, MAY, HeliumDef),
    NUMBER(per_inflation, MAY, HeliumDef),
    CYAML_FIELD_END,
};

static const cyaml_schema_field_t damping_field[] = {
    NUMBER(coefficient, MAY, DampingDef),
    NUMBER(rate, MAY, DampingDef),
    CYAML_FIELD_END,
};

static const cyaml_schema_field_t correction_field[] = {
    NUMBER(structural, MAY, CorrectionDef), NUMBER(shear, MAY, CorrectionDef),
    NUMBER(flexion, MAY, CorrectionDef),    YES_NO(tarantino, CorrectionDef),
    YES_NO(phantom, CorrectionDef),         CYAML_FIELD_END,
};

static const cyaml_schema_field_t string_field[] = {
    VECTOR(to, MAY, StringDef),
    TEXT(at, MAY, StringDef, WORD_MOST),
    NUMBER(stiffness, MUST, StringDef),
    NUMBER(slack, MAY, StringDef),
    CYAML_FIELD_END,
};
static const cyaml_schema_value_t string = {CYAML_VALUE_MAPPING(MUST, StringDef, string_field)};

static const cyaml_schema_field_t balloon_field[] = {
    TEXT(model, MUST, BalloonDef, TEXT_MOST),
    VECTOR(position, MAY, BalloonDef),
    NUMBER(size, MAY, BalloonDef),
    NUMBER(scale, MAY, BalloonDef),
    NUMBER(turn, MAY, BalloonDef),
    VECTOR(color, MAY, BalloonDef),
    GROUP(skin, MAY, BalloonDef, skin_field),
    GROUP_OR_NULL(mass, BalloonDef, mass_field),
    YES_NO(hold_rim, BalloonDef),
    GROUP_OR_NULL(inflation, BalloonDef, inflation_field),
    GROUP_OR_NULL(helium, BalloonDef, helium_field),
    GROUP_OR_NULL(damping, BalloonDef, damping_field),
    GROUP_OR_NULL(correction, BalloonDef, correction_field),
    GROUPS(strings, MAY, BalloonDef, &string, 0),
    CYAML_FIELD_END,
};
static const cyaml_schema_value_t balloon = {CYAML_VALUE_MAPPING(MUST, BalloonDef, balloon_field)};

static const cyaml_schema_field_t sphere_field[] = {
    VECTOR(position, MUST, SphereDef),
    VECTOR(velocity, MAY, SphereDef),
    NUMBER(radius, MUST, SphereDef),
    NUMBER(mass, MUST, SphereDef),
    NUMBER(restitution, MAY, SphereDef),
    NUMBER(friction, MAY, SphereDef),
    CYAML_FIELD_END,
};
static const cyaml_schema_value_t sphere = {CYAML_VALUE_MAPPING(MUST, SphereDef, sphere_field)};

static const cyaml_schema_field_t wall_field[] = {
    VECTOR(at, MUST, WallDef),
    VECTOR(normal, MUST, WallDef),
    CYAML_FIELD_END,
};
static const cyaml_schema_value_t wall = {CYAML_VALUE_MAPPING(MUST, WallDef, wall_field)};

static const cyaml_schema_field_t pipe_field[] = {
    NUMBER(from, MUST, PipeDef), NUMBER(to, MUST, PipeDef), NUMBER(conductance, MUST, PipeDef),
    NUMBER(start, MAY, PipeDef), CYAML_FIELD_END,
};
static const cyaml_schema_value_t pipe = {CYAML_VALUE_MAPPING(MUST, PipeDef, pipe_field)};

static const cyaml_schema_field_t solver_field[] = {
    NUMBER(iterations, MAY, SolverDef),
    NUMBER(tolerance, MAY, SolverDef),
    NUMBER(linear_tolerance, MAY, SolverDef),
    YES_NO(fixed, SolverDef),
    NAME(start, MAY, SolverDef, step_start_word),
    YES_NO(in_place, SolverDef),
    YES_NO(paper_tangent, SolverDef),
    CYAML_FIELD_END,
};

static const cyaml_schema_field_t about_field[] = {
    TEXT(output, MAY, AboutDef, WORD_MOST),
    NUMBER(at, MAY, AboutDef),
    NUMBER(tolerance, MAY, AboutDef),
    TEXT(none, MAY, AboutDef, TEXT_MOST),
    CYAML_FIELD_END,
};
static const cyaml_schema_value_t about = {CYAML_VALUE_MAPPING(MUST, AboutDef, about_field)};

static const cyaml_schema_field_t because_field[] = {
    TEXT(part, MUST, BecauseDef, WORD_MOST),
    TEXT(reason, MUST, BecauseDef, TEXT_MOST),
    CYAML_FIELD_END,
};
static const cyaml_schema_value_t because = {CYAML_VALUE_MAPPING(MUST, BecauseDef, because_field)};

static const cyaml_schema_value_t words = {
    CYAML_VALUE_STRING(CYAML_FLAG_POINTER, char*, 1, TEXT_MOST)};

static const cyaml_schema_field_t fails_field[] = {
    NUMBER(at, MUST, FailsDef),
    YES_NO(halts, FailsDef),
    TEXT(output, MAY, FailsDef, WORD_MOST),
    NUMBER_OR_NULL(above, FailsDef),
    NUMBER_OR_NULL(below, FailsDef),
    NUMBER_OR_NULL(truth, FailsDef),
    GROUPS(cure, MAY, FailsDef, &words, 0),
    CYAML_FIELD_END,
};

static const cyaml_schema_field_t camera_field[] = {
    VECTOR(eye, MUST, CameraDef),
    VECTOR(look, MUST, CameraDef),
    CYAML_FIELD_END,
};

static const cyaml_schema_field_t world_field[] = {
    TEXT(title, MAY, WorldDef, TEXT_MOST),
    NAME(units, MAY, WorldDef, units_word),
    NUMBER(step, MUST, WorldDef),
    NUMBER_OR_NULL(gravity, WorldDef),
    NUMBER_OR_NULL(floor, WorldDef),
    NAME(guard, MAY, WorldDef, guard_word),
    NAME(precision, MAY, WorldDef, precision_word),
    TEXT(method, MAY, WorldDef, WORD_MOST),
    GROUP(solver, MAY, WorldDef, solver_field),
    TEXT(show, MAY, WorldDef, WORD_MOST),
    NUMBER(rest, MAY, WorldDef),
    NUMBER(seconds, MAY, WorldDef),
    GROUP_OR_NULL(camera, WorldDef, camera_field),
    GROUPS(about, MAY, WorldDef, &about, 0),
    GROUPS(because, MAY, WorldDef, &because, 0),
    GROUP_OR_NULL(fails, WorldDef, fails_field),
    NAME(contact, MAY, WorldDef, contact_law_word),
    GROUPS(spheres, MAY, WorldDef, &sphere, 0),
    GROUPS(walls, MAY, WorldDef, &wall, 0),
    GROUPS(pipes, MAY, WorldDef, &pipe, 0),
    GROUPS(balloons, MUST, WorldDef, &balloon, 1),
    CYAML_FIELD_END,
};
static const cyaml_schema_value_t world = {CYAML_VALUE_MAPPING(LIST, WorldDef, world_field)};

static void name(cyaml_strval_t* word, const char* const* text, int count) {
    for (int i = 0; i < count; i++)
        word[i] = (cyaml_strval_t){.str = text[i], .val = i};
}

const cyaml_schema_value_t* scene_schema(void) {
    name(units_word, units_name, UNITS_COUNT);
    name(precision_word, precision_name, PRECISIONS);
    name(guard_word, guard_name, GUARD_COUNT);
    name(spring_law_word, spring_law_name, SPRING_LAWS);
    name(inflation_law_word, inflation_law_name, INFLATION_LAWS);
    name(contact_law_word, contact_law_name, CONTACT_LAWS);
    name(volume_rule_word, volume_rule_name, VOLUME_RULES);
    name(step_start_word, step_start_name, STEP_STARTS);
    return &world;
}
