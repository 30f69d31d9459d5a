#include <algorithm>
#include <cmath>

#include "hud/parts.hpp"

// A box at the lower left: a track with notches, and lines of text below.
namespace hud {
namespace {

// All in pixels at scale 1.
constexpr float TRACK_WIDTH = 300;
constexpr float TRACK_HEIGHT = 20;
constexpr float NOTCH_RADIUS = 3;
constexpr float THUMB_RADIUS = 7;

struct Track {
    ImVec2 low; // of the box
    ImVec2 size;
    float left, right, y;
};

Track track_of(const LabSlider& slider, ImVec2 size) {
    Track track;
    const float lines = static_cast<float>(1 + slider.lines);
    track.size = ImVec2((TRACK_WIDTH + 2 * PADDING) * scale,
                        (lines * LINE + TRACK_HEIGHT + 2 * PADDING) * scale);
    track.low = ImVec2(MARGIN * scale, size.y - MARGIN * scale - track.size.y);
    track.left = track.low.x + PADDING * scale;
    track.right = track.left + TRACK_WIDTH * scale;
    track.y = track.low.y + (PADDING + LINE + TRACK_HEIGHT / 2) * scale;
    return track;
}

// Whether the slider fits beside the lab panel.
bool fits(const Track& track, ImVec2 size) {
    return size.x >= 1.95f * track.size.x && size.y >= 2 * track.size.y;
}

float notch_x(const LabSlider& slider, const Track& track, int notch) {
    const int last = std::max(slider.notches - 1, 1);
    return track.left +
           (track.right - track.left) * static_cast<float>(notch - 1) / static_cast<float>(last);
}

} // namespace

void draw_slider(const LabSlider& slider, ImVec2 size) {
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const Track track = track_of(slider, size);
    if (!fits(track, size))
        return;
    const float top = track.low.y + PADDING * scale;
    box(track.low, track.size, GLASS);
    text(track.left, top, TITLE, "fast");
    text(track.right - width_of("accurate"), top, TITLE, "accurate");
    list->AddLine(ImVec2(track.left, track.y), ImVec2(track.right, track.y), LABEL, scale);
    for (int k = 1; k <= slider.notches; k++)
        list->AddCircleFilled(ImVec2(notch_x(slider, track, k), track.y), NOTCH_RADIUS * scale,
                              LABEL);
    if (slider.notch > 0)
        list->AddCircleFilled(ImVec2(notch_x(slider, track, slider.notch), track.y),
                              THUMB_RADIUS * scale, TRUTH);
    for (int k = 0; k < slider.lines; k++)
        text(track.left, top + (LINE * static_cast<float>(k + 1) + TRACK_HEIGHT) * scale, VALUE,
             slider.line[k]);
}

int slider_notch(const LabSlider& slider, ImVec2 size, ImVec2 point) {
    const Track track = track_of(slider, size);
    const float reach = PADDING * scale;
    if (!fits(track, size) || slider.notches == 0 || std::fabs(point.y - track.y) > reach ||
        point.x < track.left - reach || point.x > track.right + reach)
        return 0;
    const float fraction = (point.x - track.left) / (track.right - track.left);
    const float notch = std::round(fraction * static_cast<float>(slider.notches - 1));
    return 1 + std::clamp(static_cast<int>(notch), 0, slider.notches - 1);
}

} // namespace hud
