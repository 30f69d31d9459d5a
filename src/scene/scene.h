/// A scene file as plain data: YAML, y up, SI units or the mass-spring paper's own.
///
/// The structs below are the scene format: one field, one key, one row of scene/keys/.
/// A scene names only what it needs. A part without a key is neither computed nor stored: its field
/// is a NULL pointer, an empty list, or the row's default, 0 unless a field states another.
/// Where 0 is a meaningful value, the field is a pointer, and NULL means that the key is absent.
/// Keys that a scene must have are marked "required"; lists of numbers have exactly the length
/// in brackets.
///
///     title: The squirrel turns upside down
///     units: paper
///     step: 0.002
///     balloons:
///       - model: squirrel.obj
///         skin: {springs: {structural: 50, shear: 10, flexion: 10, law: hooke}}
///         mass: {per_particle: 0.001}
///         inflation: {law: area, amount: 20}
///         strings: [{to: [0, -6, 0], at: nearest, stiffness: 50, slack: 1.2}]
#ifndef BALLOON_SCENE_SCENE_H
#define BALLOON_SCENE_SCENE_H

#include <stddef.h>

#include "base/fault.h"
#include "body/body.h"
#include "contact/contact_law.h"
#include "scene/pool.h"
#include "solve/method.h"

/// What to do with a step above the stability bound (world/guard/guard.h).
typedef enum Guard { GUARD_SPLIT, GUARD_STOP, GUARD_OFF, GUARD_COUNT } Guard;
extern const char* const guard_name[GUARD_COUNT];

typedef enum Units { UNITS_SI, UNITS_PAPER, UNITS_COUNT } Units;
extern const char* const units_name[UNITS_COUNT];

typedef enum Precision { PRECISION_ANY, PRECISION_FLOAT, PRECISION_DOUBLE, PRECISIONS } Precision;
extern const char* const precision_name[PRECISIONS];

/// `springs:` stiffness of each kind [N/m]; a kind that is 0 does not exist.
typedef struct SpringsDef {
    double structural;
    double shear;
    double flexion;
    double torsion; ///< [N m], the one kind that acts on an angle
    SpringLaw law;
} SpringsDef;

/// `patches:` a round part of the skin; its thickness changes smoothly into that around it.
typedef struct PatchDef {
    double* at;       ///< [3] its center, in the world at rest, required
    double radius;    ///< of the patch [m] required
    double thickness; ///< at its center [m] required
} PatchDef;

/// `membrane:` a skin of rubber with thickness (body/membrane.h).
typedef struct MembraneDef {
    char* material;                            ///< a row of the table of materials, required
    double parameter[MATERIAL_PARAMETERS_MAX]; ///< the material's own, in its row's order
    double young;                              ///< E [Pa] required
    double density;                            ///< [kg/m^3] required
    double thickness;                          ///< [m] required
    VolumeRule volume;
    PatchDef* patches;
    unsigned patches_count;
} MembraneDef;

/// `skin:` one of the two, or neither; the other is NULL.
typedef struct SkinDef {
    SpringsDef* springs;
    MembraneDef* membrane;
} SkinDef;

typedef struct MassDef {
    double per_particle; ///< [kg] required
} MassDef;

/// `fill:` the amount changes linearly to `to` between start and start + seconds.
typedef struct FillDef {
    double to;      ///< in units of amount, required
    double start;   ///< [s]
    double seconds; ///< [s] greater than 0, required
} FillDef;

typedef struct InflationDef {
    InflationLaw law; ///< required
    double amount; ///< area: k_normal; pressure: [Pa] gauge; gas: in units of the gas that fills V0
                   ///< at `unit`
    double rate;   ///< amount per second while the key is held; 0: a tenth of the range
    double min;    ///< the smallest amount that keys set
    double max;    ///< the largest; 0: ten times the amount, or 100 where that is not above 0
    double* ambient;     ///< gas: pressure outside [Pa]; NULL: 101325
    double* unit;        ///< gas: pressure of amount 1 in V0 [Pa]; NULL: ambient's, or
                         ///< 101325 where that is 0
    double* temperature; ///< gas: [K]; NULL: 293.15, at which amount is counted
    bool adiabatic;      ///< gas: no heat passes through the skin
    char* filling;       ///< gas: air or helium, with its weight and buoyancy; NULL: no weight
    double leak;         ///< gas: amount lost per second and pascal of gauge pressure [1/(s Pa)]
    double vent;         ///< gas: the same through the valve while the deflate key is held;
                         ///< 0: rate per 1000 Pa
    FillDef* fill;
} InflationDef;

typedef struct StringDef {
    double* to; ///< [3] fixed end; NULL: straight down to the floor
    char* at;   ///< particle: "nearest" to the fixed end, "lowest", "highest", or its number;
                ///< NULL: nearest, or lowest where `to` is NULL
    double* to_balloon; ///< number of another balloon that it leads to; NULL: none
    double* to_knot;    ///< number of a knot that it leads to; NULL: none
    double* to_thing;   ///< number of a thing that it leads to; NULL: none
    char* to_at;      ///< particle of that balloon, or point of that thing, as `at`; NULL: nearest
                      ///< to this string's
    double stiffness; ///< [N/m] required
    double slack;     ///< free length as a ratio of the first length; default 1
} StringDef;

/// Whether a string leads to a balloon, a knot or a thing, and not to a fixed point.
static inline bool string_joins(const StringDef* string) {
    return string->to_balloon || string->to_knot || string->to_thing;
}

/// `pins:` particles that are held.
typedef struct PinDef {
    double* at;       ///< [3] all particles up to `radius` from this point at the start; required
    double radius;    ///< [m] required
    double* to_thing; ///< number of the thing that holds them; NULL: they do not move
} PinDef;

/// Thresholds: largest strain of a spring [1]; 0: not limited.
typedef struct StrainLimitDef {
    double structural;
    double shear;
    double flexion;
    bool tarantino; ///< a corrected spring exerts no force in the next step
    bool phantom;   ///< the correction does not change velocities
} StrainLimitDef;

typedef struct BalloonDef {
    char* model;      ///< a shape, or an .obj beside the scene or in assets/models; required
    double* position; ///< [3] added to the model's points; NULL: the origin
    double size;      ///< the model is centered on the origin, and its longest side scaled to
                      ///< this length; 0: neither
    double scale;     ///< factor on the model's points; default 1
    double rotation;  ///< [degrees] about y, before the position is added
    double* color;    ///< [3] sRGB, 0…1; NULL: the next of the palette
    SkinDef skin;
    MassDef* mass; ///< required for springs; a membrane has its rubber's
    bool hold_rim; ///< the points on the rim of an open mesh are fixed
    InflationDef* inflation;
    double* force[FORCES_MAX]; ///< [FORCE_PARAMETERS_MAX] parameters of each row of the table of
                               ///< forces; NULL: the scene lacks the key of its name
    StrainLimitDef* strain_limit;
    StringDef* strings;
    unsigned strings_count;
    PinDef* pins;
    unsigned pins_count;
} BalloonDef;

/// `spheres:` balls that exist from the start.
typedef struct SphereDef {
    double* position;   ///< [3] required
    double* velocity;   ///< [3] NULL: at rest
    double radius;      ///< [m] required
    double mass;        ///< [kg] required
    double restitution; ///< 0 … 1
    double friction;    ///< Coulomb's coefficient
} SphereDef;

/// `walls:` half-spaces beside the floor.
typedef struct WallDef {
    double* at;      ///< [3] a point of the wall, required
    double* normal;  ///< [3] into the free half-space, of any length, required
    double friction; ///< Coulomb's coefficient of skins on it
} WallDef;

/// `path:` where a thing is at a time.
typedef struct PathPointDef {
    double at;        ///< [s]
    double* position; ///< [3] required
    double* rotation; ///< [3] degrees about x, then y, then z, after the thing's own; NULL: none
} PathPointDef;

/// `things:` meshes of infinite mass (contact/things/thing.h).
typedef struct ThingDef {
    char* model;      ///< a shape, or a mesh file beside the scene or in assets/models; required
    double* position; ///< [3] of the model's origin; NULL: the origin, or the path's
    double* size;     ///< [3] sides of the model's bounding box, which is centered on the position;
                      ///< NULL: as it is
    double scale;     ///< factor on the model's points; default 1
    double* rotation; ///< [3] degrees about x, then y, then z; NULL: none
    double* color;    ///< [3] sRGB, 0…1; NULL: gray
    double friction;  ///< Coulomb's coefficient of skins on it
    PathPointDef* path;
    unsigned path_count;
} ThingDef;

/// `knots:` points that strings share (solve/joints/joints.h).
typedef struct KnotDef {
    double* position; ///< [3] required without a path
    double mass;      ///< [kg] 0: it is held
    PathPointDef* path;
    unsigned path_count;
} KnotDef;

/// `pipes:` gas flows from the higher pressure to the lower.
typedef struct PipeDef {
    double from;        ///< number of a balloon, required
    double to;          ///< of another, required
    double conductance; ///< p V that flows per second and pascal [m^3/s] required
    double start;       ///< when it is opened [s]
} PipeDef;

/// `solver:` how a method solves its steps (solve/method.h); 0: the method's default.
typedef struct SolverDef {
    double iterations;
    double tolerance;
    double linear_tolerance;
    bool fixed; ///< make all iterations, whatever the residual
    StepStart start;
    bool in_place;      ///< euler moves each particle before the next one's force is computed
    bool paper_tangent; ///< the gas's stiffness is the thin-shell paper's, a third of the right one
} SolverDef;

/// `about:` the outputs that a scene is made for; `balloon needs` finds the parts that they depend
/// on. Or one item `none:` with the reason why the scene has no such output.
typedef struct AboutDef {
    char* output;     ///< a CSV column
    double at;        ///< [s]
    double tolerance; ///< relative, of the output's size; required with it
    char* none;       ///< the reason; then the other members are absent
} AboutDef;

/// `because:` why the scene keeps a part that its outputs do not depend on (lab/advice/needs.h).
typedef struct BecauseDef {
    char* part;   ///< a part's name in `balloon needs`, required
    char* reason; ///< required
} BecauseDef;

/// `fails:` how a scene of the museum of failures fails, and overrides that prevent it: the world
/// halts at a bad state, or an output is on the wrong side of a limit. Tests check both for every
/// scene of assets/scenes/fails (world/fails.h).
typedef struct FailsDef {
    double at;     ///< latest time of the failure [s] required
    bool halts;    ///< the world halts at a bad state; otherwise output is required
    char* output;  ///< a CSV column
    double* above; ///< it fails where the output is above this
    double* below; ///< or below this
    double* truth; ///< the right value of the output
    char** cure;   ///< overrides, KEY=VALUE, with which it does not fail; NULL: none is known
    unsigned cure_count;
} FailsDef;

/// `camera:` without one, the picture shows the whole scene.
typedef struct CameraDef {
    double* eye;  ///< [3] required
    double* look; ///< [3] the point in the middle of the picture, required
} CameraDef;

typedef struct WorldDef {
    char* title;
    Units units;
    double step;           ///< [s] required
    double* gravity;       ///< [m/s^2] downward; NULL: 9.81, or 9.8 in the paper's units
    double* floor;         ///< height of the floor [m]; NULL: none
    double floor_friction; ///< Coulomb's coefficient of skins on it
    Guard guard;
    Precision precision;
    char* method; ///< a row of the method table; NULL: its first
    SolverDef solver;
    char* show;             ///< the first display mode; NULL: skin
    double sleep_threshold; ///< a balloon sleeps below this speed over its size; 0: never [1/s]
    double seconds;         ///< [s] how long headless runs last without --seconds; default 10
    CameraDef* camera;
    AboutDef* about;
    unsigned about_count;
    BecauseDef* because;
    unsigned because_count;
    FailsDef* fails;       ///< NULL: the scene does not fail
    ContactLaw contact;    ///< of balls with skins
    SkinContacts contacts; ///< of skins
    SphereDef* spheres;
    unsigned spheres_count;
    WallDef* walls;
    unsigned walls_count;
    ThingDef* things;
    unsigned things_count;
    KnotDef* knots;
    unsigned knots_count;
    PipeDef* pipes;
    unsigned pipes_count;
    BalloonDef* balloons; ///< at least one, required
    unsigned balloons_count;

    char file[512];    ///< path of the scene file, for messages and for models beside it
    char renamed[256]; ///< keys by earlier names: "turn is now rotation, …"; "": none
    Pool pool;         ///< memory of all pointers above; scene_free() frees it
} WorldDef;

/// One `--set KEY=VALUE`: any key of the scene by its path, and its new value in YAML, as in
/// "balloons.0.inflation.amount=10" or "balloons.0.color=[1, 0, 0]".
/// A path may name a key that the scene does not have yet; list items must exist. The value ~ takes
/// the key out of the scene.
typedef struct SceneSet {
    const char* text; ///< "KEY=VALUE" as typed
} SceneSet;

/// Load `name`: a scene by its name in assets/scenes or its path, or a mesh (shape or .obj), which
/// gets default springs and a string to the floor. Overrides are applied before any check.
/// Unknown keys, wrong types, unknown names and numbers out of range are faults with file and line,
/// or with the override that contains them.
bool scene_load(const char* name, const SceneSet* set, int set_count, WorldDef* def, Fault* fault);

/// Print one sentence on stderr where a scene has keys by earlier names, which are still read.
void scene_say_renamed(const WorldDef* def);

/// The scene with its overrides as YAML: for people, or unambiguous with all scalars in quotes. The
/// caller frees it; NULL with a fault where scene_load has one.
char* scene_text(const char* name, const SceneSet* set, int set_count, bool for_people,
                 Fault* fault);

/// The path of a balloon's model: a shape's name itself, or a file beside the scene's, in
/// assets/models or relative to the working folder. The fault names the paths tried.
bool scene_model_path(const WorldDef* def, const char* model, char path[512], Fault* fault);

/// The paths of all shipped scenes in order of name: for `balloon list`, next and previous, tests.
/// The caller frees each string and the array. Returns the count.
int scene_list(char*** path);

/// The name by which scene_load finds a shipped scene: "party", "fails/stiff".
void scene_name(const char* path, char name[256]);

/// The outputs that the scene is about, def->about[0 … count); 0 where it is about none.
static inline unsigned scene_outputs(const WorldDef* def) {
    return def->about_count > 0 && def->about[0].none ? 0 : def->about_count;
}

/// Downward, from the scene or its units [m/s^2].
static inline double scene_gravity(const WorldDef* def) {
    return def->gravity ? *def->gravity : def->units == UNITS_PAPER ? 9.8 : 9.81;
}

/// A fault of a scene with overrides that it does not have without them names the first override
/// with which it has: the user wrote that, and not the scene's line. opens: whether the scene opens
/// with the first `set_count` overrides.
void scene_blame(const char* name, const SceneSet* set, int set_count,
                 bool (*opens)(const char* name, const SceneSet* set, int set_count), Fault* fault);

void scene_free(WorldDef* def);

#endif
