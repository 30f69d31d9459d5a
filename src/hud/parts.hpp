/// Shared by the files of the overlay: colors, sizes, and basic shapes.
#ifndef BALLOON_HUD_PARTS_HPP
#define BALLOON_HUD_PARTS_HPP

#include <imgui.h>

#include "view/lab_panel.h"

namespace hud {

constexpr ImU32 GLASS = IM_COL32(17, 20, 28, 190);
constexpr ImU32 ALARM = IM_COL32(158, 20, 26, 230);
constexpr ImU32 TITLE = IM_COL32(255, 219, 140, 255);
constexpr ImU32 LABEL = IM_COL32(170, 182, 200, 255);
constexpr ImU32 VALUE = IM_COL32(246, 247, 250, 255);
constexpr ImU32 PLATE = IM_COL32(255, 255, 255, 18); // behind a plot
constexpr ImU32 TRUTH = IM_COL32(255, 170, 70, 255);
constexpr ImU32 LINE_COLOR = IM_COL32(118, 196, 255, 255);

// All in pixels at scale 1.
constexpr float FONT_SIZE = 13; // size of ImGui's own bitmap font
constexpr float LINE = 18;      // height of a line of text
constexpr float MARGIN = 14;    // from the picture's edge to a box
constexpr float PADDING = 12;   // from a box's edge to its text
constexpr float GAP = 16;       // between the columns
constexpr float ROUND = 8;      // radius of a box's corners

extern float scale;

float width_of(const char* text);
void box(ImVec2 low, ImVec2 size, ImU32 color);
void text(float x, float y, ImU32 color, const char* words);

/// Draw the lab panel along the right edge of a picture of this size [px]; returns the box's left
/// end [px].
float draw_lab_panel(const LabPanel& panel, ImVec2 size);

/// Find the cell {row, column} of its map under a point [px]; false: none.
bool lab_panel_cell(const LabPanel& panel, ImVec2 size, ImVec2 point, int cell[2]);

/// Draw the slider at the lower left; find its notch under a point [px]: 1 …, or 0 for none.
void draw_slider(const LabSlider& slider, ImVec2 size);
int slider_notch(const LabSlider& slider, ImVec2 size, ImVec2 point);

} // namespace hud

#endif
