/// A map of where a scene's step fails: of its first balloon alone, by its method, over steps and
/// stiffnesses about the scene's own. Measured cell by cell, in parts, for who has frames to draw.
///
/// Each cell is a trial (lab/stability/trial.h), as those of `balloon stability` are: the balloon without
/// gravity, strings, helium and strain limit is brought to rest and pushed. It holds the gas that it
/// has now, or, where its law is another, a pressure that grows with the stiffness from the present
/// one, so that its size stays. Upright is the stiffness of the whole skin, in powers of two of the
/// scene's.
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
enum { MAP_UNKNOWN = -1 }; ///< not measured yet, or the state has no rest; else a Verdict

/// Overrides of a scene, with room for their own words.
typedef struct MapSets {
    int count;
    SceneSet set[MAP_SETS];
    int words; ///< the last of them are these
    char word[MAP_WORDS][MAP_WORD];
} MapSets;

typedef struct Map {
    WorldDef def;        ///< the scene
    const SceneSet* set; ///< [set_count] the caller's: overrides that it has anyway
    int set_count;
    double amount;   ///< of the first balloon's inflation
    double pressure; ///< gauge, on its skin
    real4* near;     ///< [near_count] positions near rest, from which the way there is short
    int near_count;

    int cell[MAP_ROWS][MAP_COLUMNS]; ///< verdicts
    double theory[MAP_ROWS];         ///< the method's limit; NAN: not known yet [s]
    double bound[MAP_ROWS];          ///< the program's [s]
    char why[1024];                  ///< why there is no map, or not all of it

    int turn;      ///< rows done, the scene's own first
    int column;    ///< that is being measured
    bool measures; ///< the trial is open
    bool ready;    ///< and at rest
    bool running;  ///< and a run has begun
    Trial trial;
} Map;

/// A map of the scene's file with these overrides, about the state of this world, which may be that
/// of a cell; nothing is measured yet.
void map_begin(Map* map, const World* world, const SceneSet* set, int set_count);

/// Measure one part: some steps, one where a method solves them. False when all is done.
bool map_work(Map* map);

/// Step and stiffness of a cell, the latter over the scene's own.
double map_step(const Map* map, int column); ///< [s]
double map_stiffness(int row);               ///< [1]

/// Where a step is among the columns, 0 … MAP_COLUMNS - 1 at their middles.
double map_place(const Map* map, double step);

/// What makes the whole scene that of a cell, guard off; the words are what the cell adds.
void map_sets(const Map* map, int row, int column, MapSets* sets);

void map_end(Map* map);

#endif
