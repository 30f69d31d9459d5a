#include <algorithm>
#include <cmath>
#include <cstdio>

#include "hud/parts.hpp"

// A column along the right rim: title, plots with one axis of time.
namespace hud {
namespace {

// All in pixels at scale 1.
constexpr float WIDE = 300;  // of the column, but at most
constexpr float PART = 0.4f; // of the picture
constexpr float NAMES = 70;  // of the plots' labels
constexpr float GRAPH = 46;  // height of a plot, where there is room
constexpr float LEAST = 14;  // and where there is none
constexpr float STROKE = 1.5f;
constexpr float TALL = 2.5f; // the curve, in plots
constexpr float DOT = 4;     // radius

// What moves by less than this much of its size is drawn level. [1]
constexpr float LEVEL = 1e-3f;

struct Range {
    float low, high;
    float part(float y) const {
        return (y - low) / (high - low);
    }
};

Range range_of(const float* y, int count) {
    float low = INFINITY, high = -INFINITY;
    for (int k = 0; k < count; k++)
        if (std::isfinite(y[k])) {
            low = std::min(low, y[k]);
            high = std::max(high, y[k]);
        }
    if (!(low <= high))
        return {0, 1};
    const float size = std::max(std::fabs(low), std::fabs(high));
    const float more = std::max(LEVEL * size, 1e-20f) - (high - low);
    if (more <= 0)
        return {low, high};
    return {low - more / 2, high + more / 2};
}

void line(ImVec2 a, ImVec2 b, ImU32 color) {
    ImGui::GetBackgroundDrawList()->AddLine(a, b, color, STROKE * scale);
}

void plate(ImVec2 low, ImVec2 size) {
    ImGui::GetBackgroundDrawList()->AddRectFilled(low, ImVec2(low.x + size.x, low.y + size.y),
                                                  PLATE);
}

void text_right(float x, float y, ImU32 color, const char* words) {
    text(x - width_of(words), y, color, words);
}

void draw_plot(const Page& page, const PagePlot& plot, ImVec2 low, ImVec2 size) {
    const Range range = range_of(plot.y, page.count);
    const Range time = range_of(page.t, page.count);
    plate(low, size);
    ImVec2 last;
    bool drawn = false;
    for (int k = 0; k < page.count; k++) {
        const ImVec2 at(low.x + size.x * time.part(page.t[k]),
                        low.y + size.y * (1 - range.part(plot.y[k])));
        const bool good = std::isfinite(plot.y[k]);
        if (good && drawn)
            line(last, at, LINE_COLOR);
        last = at;
        drawn = good;
    }
}

void draw_words(const Page& page, const PagePlot& plot, float left, float right, float y) {
    char ends[64];
    const float x = left + NAMES * scale;
    const Range range = range_of(plot.y, page.count);
    std::snprintf(ends, sizeof ends, "%.3g to %.3g", static_cast<double>(range.low),
                  static_cast<double>(range.high));
    text(left, y, LABEL, plot.label);
    text(x, y, VALUE, plot.value);
    if (x + width_of(plot.value) + GAP * scale + width_of(ends) <= right)
        text_right(right, y, LABEL, ends);
}

void draw_times(const Page& page, float left, float right, float y) {
    char words[32];
    if (page.count == 0)
        return;
    std::snprintf(words, sizeof words, "%.4g s", static_cast<double>(page.t[0]));
    text(left, y, LABEL, words);
    std::snprintf(words, sizeof words, "%.4g s", static_cast<double>(page.t[page.count - 1]));
    text_right(right, y, LABEL, words);
}

void draw_curve(const PageCurve& curve, ImVec2 low, ImVec2 size) {
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const auto at = [&](float l, float p) {
        return ImVec2(low.x + size.x * (l - 1) / (curve.stretch - 1),
                      low.y + size.y * (1 - p / curve.pressure));
    };
    plate(low, size);
    list->PushClipRect(low, ImVec2(low.x + size.x, low.y + size.y), true);
    for (int k = 1; k < PAGE_CURVE; k++) {
        const float step = (curve.stretch - 1) / (PAGE_CURVE - 1);
        line(at(1 + step * static_cast<float>(k - 1), curve.truth[k - 1]),
             at(1 + step * static_cast<float>(k), curve.truth[k]), TRUTH);
    }
    for (int k = 1; k < curve.count; k++)
        line(at(curve.way[k - 1][0], curve.way[k - 1][1]), at(curve.way[k][0], curve.way[k][1]),
             LINE_COLOR);
    list->PopClipRect();
    if (curve.count == 0)
        return;
    const float* now = curve.way[curve.count - 1];
    const ImVec2 dot = at(now[0], now[1]);
    list->AddCircleFilled(
        ImVec2(std::clamp(dot.x, low.x, low.x + size.x), std::clamp(dot.y, low.y, low.y + size.y)),
        DOT * scale, VALUE);
}

} // namespace

void draw_page(const Page& page, ImVec2 size) {
    const float wide = std::min(WIDE * scale, PART * size.x);
    const float right = size.x - (MARGIN + PADDING) * scale, left = right - wide;
    const float plots = static_cast<float>(page.plot_count);

    // texts have their heights, the plots share what is left
    const float lines = 1.4f + plots + 1.2f + (page.has_curve ? 2 : 0);
    const float parts = plots + (page.has_curve ? TALL : 0);
    const float words = lines * LINE * scale + 2 * PADDING * scale;
    const float rest = size.y - 2 * MARGIN * scale - words;
    const float graph = std::clamp(rest / std::max(parts, 1.0f), LEAST * scale, GRAPH * scale);
    box(ImVec2(left - PADDING * scale, MARGIN * scale),
        ImVec2(wide + 2 * PADDING * scale, words + parts * graph), GLASS);

    float y = (MARGIN + PADDING) * scale;
    text(left, y, TITLE, page.title);
    y += 1.4f * LINE * scale;
    for (int k = 0; k < page.plot_count; k++) {
        draw_words(page, page.plot[k], left, right, y);
        y += LINE * scale;
        draw_plot(page, page.plot[k], ImVec2(left, y), ImVec2(wide, graph - 4 * scale));
        y += graph;
    }
    draw_times(page, left, right, y);
    y += 1.2f * LINE * scale;
    if (page.has_curve) {
        char end[32];
        text(left, y, TITLE, "Pressure over stretch");
        text_right(right, y, TRUTH, page.curve.law);
        y += LINE * scale;
        draw_curve(page.curve, ImVec2(left, y), ImVec2(wide, TALL * graph - 4 * scale));
        y += TALL * graph;
        std::snprintf(end, sizeof end, "%.3g", static_cast<double>(page.curve.stretch));
        text_right(right, y, LABEL, end);
        text(left, y, VALUE, page.curve.value);
    }
}

} // namespace hud
