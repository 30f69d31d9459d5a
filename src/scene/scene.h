/// A scene file as plain data: YAML, y up, SI units or the mass-spring paper's own.
///
/// The structs below are the scene format: one field, one key, one row of keys.c or keys_balloon.c.
/// A scene names only what it needs; what it does not name is neither computed nor stored, and
/// stands here as a NULL pointer, an empty list, or the row's default, which is 0 unless said here.
/// Where 0 would be a value of its own, the field is a pointer and NULL says "not given".
/// Keys that a scene must have are marked "required"; lists of numbers have exactly the length
/// given.
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

/// What to do with a step above the stability bound (world/guard.h).
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

/// `patches:` a part of the skin with a thickness of its own, going over into the rest smoothly.
typedef struct PatchDef {
    double* at;       ///< [3] its middle, in the world at rest, required
    double radius;    ///< to where it reaches [m] required
    double thickness; ///< in its middle [m] required
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

/// `skin:` what holds the particles together, one of the two; NULL members are absent.
typedef struct SkinDef {
    SpringsDef* springs;
    MembraneDef* membrane;
} SkinDef;

typedef struct MassDef {
    double per_particle; ///< [kg] required
} MassDef;

/// `fill:` the amount goes in a straight line to `to` between start and start + seconds.
typedef struct FillDef {
    double to;      ///< in units of amount, required
    double start;   ///< [s]
    double seconds; ///< [s] greater than 0, required
} FillDef;

typedef struct InflationDef {
    InflationLaw law; ///< required
    double amount; ///< area: k_normal; pressure: [Pa] gauge; gas: parts of what fills V0 at `unit`
    double rate;   ///< amount per second while the key is held; 0: a tenth of the range
    double min;    ///< the keys stop here
    double max;    ///< and here; 0: ten times the amount, or 100 where that is not above 0
    double* ambient;     ///< gas: pressure outside [Pa]; NULL: 101325
    double* unit;        ///< gas: pressure of amount 1 in V0 [Pa]; NULL: ambient's, or
                         ///< 101325 where that is 0
    double* temperature; ///< gas: [K]; NULL: 293.15, at which amount is counted
    bool adiabatic;      ///< gas: no heat goes through the skin
    char* filling;       ///< gas: air or helium, which then has weight and is lifted; NULL: neither
    double leak;         ///< gas: amount lost per second and pascal of gauge pressure [1/(s Pa)]
    double vent;         ///< gas: the same through the valve while the deflate key is held;
                         ///< 0: rate per 1000 Pa
    FillDef* fill;
} InflationDef;

typedef struct StringDef {
    double* to;       ///< [3] fixed end; NULL: straight down to the floor
    char* at;         ///< particle: "nearest" to the fixed end, "lowest", "highest", or its number;
                      ///< NULL: nearest, or lowest where `to` is NULL
    double stiffness; ///< [N/m] required
    double slack;     ///< free length as a ratio of the first length; default 1
} StringDef;

/// Thresholds: how far over its rest length a spring may stretch, as a ratio; 0: not corrected.
typedef struct StrainLimitDef {
    double structural;
    double shear;
    double flexion;
    bool tarantino; ///< a spring that was corrected exerts no force in the next step
    bool phantom;   ///< velocities are left as they were before
} StrainLimitDef;

typedef struct BalloonDef {
    char* model;      ///< a shape, or an .obj beside the scene or in assets/models; required
    double* position; ///< [3] added to the model's points; NULL: the origin
    double size;      ///< first the model is centred on the origin and its longest side scaled to
                      ///< this length; 0: it stays where and as it is
    double scale;     ///< factor on the model's points; default 1
    double rotation;  ///< [degrees] about y, before the position is added
    double* color;    ///< [3] sRGB, 0…1; NULL: the next of the palette
    SkinDef skin;
    MassDef* mass; ///< required, but for a membrane, which has its rubber's
    bool hold_rim; ///< the points of an open mesh's rim do not move
    InflationDef* inflation;
    double* force[FORCES_MAX]; ///< parameters of each row of the table of forces that has some, as
                               ///< the key of its name gives them [FORCE_PARAMETERS_MAX]
    StrainLimitDef* strain_limit;
    StringDef* strings;
    unsigned strings_count;
} BalloonDef;

/// `spheres:` balls that are there from the start.
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
    double* at;     ///< [3] a point of the wall, required
    double* normal; ///< [3] to the side where things are, of any length, required
} WallDef;

/// `pipes:` gas flows from the higher pressure to the lower.
typedef struct PipeDef {
    double from;        ///< number of a balloon, required
    double to;          ///< of another, required
    double conductance; ///< p V that flows per second and pascal [m^3/s] required
    double start;       ///< when it is opened [s]
} PipeDef;

/// `solver:` how a method solves its steps (solve/method.h); 0: its own choice.
typedef struct SolverDef {
    double iterations;
    double tolerance;
    double linear_tolerance;
    bool fixed; ///< make all iterations, whatever is left
    StepStart start;
    bool in_place;      ///< euler moves each particle before the next one's force is computed
    bool paper_tangent; ///< the gas's stiffness is the thin-shell paper's, a third of the right one
} SolverDef;

/// `about:` what the scene is about, so that one can say what it may leave out: outputs, or one
/// item `none:` that says why nothing of it can be held to a number.
typedef struct AboutDef {
    char* output;     ///< a CSV column
    double at;        ///< [s]
    double tolerance; ///< relative, of the output's size; required with it
    char* none;       ///< the reason, and then there is nothing else
} AboutDef;

/// `because:` why a part stays that the scene's outputs do not need (lab/advice/needs.h).
typedef struct BecauseDef {
    char* part;   ///< a part's name in `balloon needs`, required
    char* reason; ///< required
} BecauseDef;

/// `fails:` what goes wrong in a scene of the museum of failures, and what cures it: the state goes
/// bad and is caught, or a measured number is on the wrong side of a limit. Tests hold every scene
/// of assets/scenes/fails to both (world/fails.h).
typedef struct FailsDef {
    double at;     ///< by when [s] required
    bool halts;    ///< the state goes bad; else
    char* output;  ///< this CSV column is
    double* above; ///< above this
    double* below; ///< or below this,
    double* truth; ///< where this would be right
    char** cure;   ///< overrides, KEY=VALUE, with which it does not fail; NULL: there is none
    unsigned cure_count;
} FailsDef;

/// `camera:` where the eye is; a scene without one is framed as a whole.
typedef struct CameraDef {
    double* eye;  ///< [3] required
    double* look; ///< [3] what it looks at, required
} CameraDef;

typedef struct WorldDef {
    char* title;
    Units units;
    double step;     ///< [s] required
    double* gravity; ///< [m/s^2] downward; NULL: 9.81, or 9.8 in the paper's units
    double* floor;   ///< height of the floor [m]; NULL: none
    Guard guard;
    Precision precision;
    char* method; ///< a row of the method table; NULL: its first
    SolverDef solver;
    char* show;             ///< the display mode to begin with; NULL: skin
    double sleep_threshold; ///< a balloon sleeps below this speed over its size; 0: never [1/s]
    double seconds;         ///< [s] how long headless runs last without --seconds; default 10
    CameraDef* camera;
    AboutDef* about;
    unsigned about_count;
    BecauseDef* because;
    unsigned because_count;
    FailsDef* fails;    ///< NULL: it does not
    ContactLaw contact; ///< what balls and skins do to each other
    SphereDef* spheres;
    unsigned spheres_count;
    WallDef* walls;
    unsigned walls_count;
    PipeDef* pipes;
    unsigned pipes_count;
    BalloonDef* balloons; ///< at least one, required
    unsigned balloons_count;

    char file[512];    ///< where it came from, for messages and for models beside it
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
/// gets default springs and a string to the floor. Overrides are applied before anything is judged.
/// Unknown keys, wrong types, unknown names and numbers out of range are faults with file and line,
/// or with the override that brought them in.
bool scene_load(const char* name, const SceneSet* set, int set_count, WorldDef* def, Fault* fault);

/// One sentence on stderr where a scene has keys by earlier names, which are read all the same.
void scene_say_renamed(const WorldDef* def);

/// The scene with its overrides as YAML again, for people or with nothing left to guess: scalars in
/// quotes. The caller frees it; NULL with a fault where scene_load has one.
char* scene_text(const char* name, const SceneSet* set, int set_count, bool for_people,
                 Fault* fault);

/// Where a balloon's model is: a shape's name as it is, a file beside the scene's, in assets/models
/// or as typed from the working folder. The fault names the places tried.
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
