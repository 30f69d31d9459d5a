/// Draws an Overlay with Dear ImGui on the bound framebuffer, in the window as headless. C interface
/// of hud.cpp.
#ifndef BALLOON_HUD_HUD_H
#define BALLOON_HUD_HUD_H

#ifdef __cplusplus
extern "C" {
#endif

#include "base/fault.h"
#include "view/overlay.h"

/// A GL context must be current. scale: 1 for a plain screen, 2 for a high-density one; rounded to
/// a whole number.
bool hud_open(float scale, Fault* fault);

/// Draw the overlay over a framebuffer of this size.
void hud_draw(const Overlay* overlay, int width, int height);

/// Find the cell {row, column} of the stability map under a point, 0…1 from the upper left. Returns
/// false if there is none.
bool hud_cell(const Overlay* overlay, int width, int height, const float point[2], int cell[2]);

/// The notch of the slider under a point, 1 …; 0: none.
int hud_notch(const Overlay* overlay, int width, int height, const float point[2]);

void hud_close(void);

#ifdef __cplusplus
}
#endif

#endif
