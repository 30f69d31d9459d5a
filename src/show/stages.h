/// Where the time of a frame goes, stage by stage, as the caller's thread sees it. `render --time`
/// and a window that is left print the table.
#ifndef BALLOON_SHOW_STAGES_H
#define BALLOON_SHOW_STAGES_H

#include "draw/renderer.h"

typedef enum Stage {
    STAGE_STEPS,   ///< the world's steps
    STAGE_PICTURE, ///< positions, normals, colors
    STAGE_UPLOAD,  ///< sort by depth, arrays to the driver
    STAGE_SHADOW,  ///< the floor's
    STAGE_SCENE,   ///< draw
    STAGE_RESOLVE, ///< multisamples, glow
    STAGE_OVERLAY, ///< status box and sentences
    STAGE_PRESENT, ///< to the window, or read back and written
    STAGES
} Stage;

extern const char* const stage_name[STAGES];

enum { RECENT_FRAMES = 64 };

typedef struct Stages {
    double ms[STAGES];                    ///< sum over the frames
    double recent[RECENT_FRAMES][STAGES]; ///< of the last frames, round and round
    double stage_start;                   ///< when the present stage began [ms]
    long frames;
} Stages;

/// Wall time from some moment [ms].
double stages_now(void);

void stages_begin(Stages* stages);

/// What has passed since the last call belongs to this stage.
void stages_end(Stages* stages, Stage stage);

/// The same for what the renderer has measured itself.
void stages_drawn(Stages* stages, RendererTimes times);

/// Mean milliseconds of a frame.
void stages_print(const Stages* stages);

#endif
