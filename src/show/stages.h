/// Wall time of the stages of a frame in the main thread. With --time, `render` and a closed window
/// print the means.
#ifndef BALLOON_SHOW_STAGES_H
#define BALLOON_SHOW_STAGES_H

#include "draw/renderer.h"

typedef enum Stage {
    STAGE_STEPS,   ///< the world's steps
    STAGE_PICTURE, ///< positions, normals, colors
    STAGE_UPLOAD,  ///< sort by depth, upload arrays
    STAGE_SHADOW,  ///< compute the floor's shadow
    STAGE_SCENE,   ///< draw
    STAGE_RESOLVE, ///< resolve multisamples, draw the glow
    STAGE_OVERLAY, ///< draw the overlay
    STAGE_PRESENT, ///< display, or read back and write
    STAGES
} Stage;

extern const char* const stage_name[STAGES];

enum { RECENT_FRAMES = 64 };

typedef struct Stages {
    double ms[STAGES];                    ///< sum over the frames
    double recent[RECENT_FRAMES][STAGES]; ///< the last frames, a ring [ms]
    double stage_start;                   ///< time at which the present stage began [ms]
    long frames;
} Stages;

/// Monotonic wall time [ms].
double stages_now(void);

void stages_begin(Stages* stages);

/// Add the time since the last call to this stage.
void stages_end(Stages* stages, Stage stage);

/// Add the times of the renderer's stages, which it has measured itself.
void stages_drawn(Stages* stages, RendererTimes times);

/// Print the mean times of a frame [ms].
void stages_print(const Stages* stages);

#endif
