/// A map of stable steps: of a scene's first balloon alone, by its method, over steps and
/// stiffnesses around the scene's own. It is measured cell by cell in small parts, between frames.
///
/// Each cell is a trial (lab/stability/trial.h), as in `balloon stability`: the balloon without
/// gravity, strings, helium and strain limit is brought to rest and perturbed. It holds its present
/// amount of gas or, under another inflation law, the present pressure times the factor of
/// stiffness, so that its size stays. Rows multiply the stiffness of the whole skin by powers of
/// two.
#ifndef BALLOON_LAB_STABILITY_MAP_H
#define BALLOON_LAB_STABILITY_MAP_H

#include "lab/stability/trial.h"

enum {
    MAP_ROWS = 9,      ///< stiffness times 2^(row - MAP_OWN_ROW)
    MAP_COLUMNS = 17,  ///< step times 2^((column - MAP_OWN_COLUMN)/2)
    MAP_OWN_ROW = 4,   ///< the scene's own stiffness
    MAP_OWN_COLUMN = 6 ///< and step
};
enum { MAP_SETS = 160, MAP_WORDS = 16, MAP_WORD = 96 };
enum { MAP_UNKNOWN = -1 }; ///< not measured yet, or the balloon has no rest; else a Verdict

/// Overrides of a scene, and storage for the texts of the last ones.
typedef struct MapSets {
    int count;
    SceneSet set[MAP_SETS];
    int words; ///< number of texts stored here
    char word[MAP_WORDS][MAP_WORD];
} MapSets;

typedef struct Map {
    WorldDef def;        ///< the scene
    const SceneSet* set; ///< [set_count] the scene's own overrides, owned by the caller
    int set_count;
    double amount;   ///< of the first balloon's inflation
    double pressure; ///< gauge, on its skin
    real4* near;     ///< [near_count] positions near rest, the initial guess of the next rest
    int near_count;

    int cell[MAP_ROWS][MAP_COLUMNS]; ///< verdicts
    double theory[MAP_ROWS];         ///< the method's limit; NAN: not known yet [s]
    double bound[MAP_ROWS];          ///< the program's [s]
    char why[1024];                  ///< why there is no map, or not all of it

    int rows_done; ///< the scene's own row is the first
    int column;    ///< present column
    bool is_open;  ///< the trial is open
    bool at_rest;  ///< the trial is prepared
    bool running;  ///< a run has begun
    Trial trial;
} Map;

/// Begin a map of the scene with these overrides; the world's present state gives gas and pressure.
/// Nothing is measured yet.
void map_begin(Map* map, const World* world, const SceneSet* set, int set_count);

/// Measure one part: one step of an iterative method, several of others. False: the map is
/// complete.
bool map_work(Map* map);

/// Step and stiffness of a cell, the latter over the scene's own.
double map_step(const Map* map, int column); ///< [s]
double map_stiffness(int row);               ///< [1]

/// The position of a step on the axis of columns: k at the middle of column k.
double map_position(const Map* map, double step);

/// The overrides that give the whole scene the step and stiffness of a cell, guard off; the stored
/// texts are those that the cell adds.
void map_sets(const Map* map, int row, int column, MapSets* sets);

void map_end(Map* map);

#endif
