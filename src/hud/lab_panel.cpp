#include <algorithm>
#include <cmath>
#include <cstdio>

#include "hud/parts.hpp"

// A column along the right edge: title, plots over one time axis, the curve of a balloon with a
// closed form, the stability map.
namespace hud {
namespace {

// All in pixels at scale 1.
constexpr float MAX_WIDTH = 300;  // of the column
constexpr float MAX_SHARE = 0.4f; // of the column, over the picture's width
constexpr float LABEL_WIDTH = 78; // of the plots' labels
constexpr float PLOT_HEIGHT = 46; // largest height of a plot
constexpr float MIN_PLOT_HEIGHT = 14;
constexpr float TITLE_LINES = 1.4f; // height of the title, in lines
constexpr float AXIS_LINES = 1.2f;  // height of an axis' text below a plot, in lines
constexpr float LINE_WIDTH = 1.5f;
constexpr float CURVE_PLOTS = 2.5f; // height of the curve and of the map, in plots
constexpr float DOT = 4;            // radius

// The colors of `balloon stability`.
constexpr ImU32 CELL[LAB_CELLS] = {0, IM_COL32(158, 202, 225, 255), IM_COL32(254, 196, 79, 255),
                                   IM_COL32(203, 24, 29, 255)};
constexpr ImU32 EDGE = IM_COL32(10, 12, 16, 255);

// A plot's range is at least this share of its values: rounding is not magnified. [1]
constexpr float FLAT = 1e-3f;

struct Range {
    float low, high;
    float fraction(float y) const {
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
    const float missing = std::max(FLAT * size, 1e-20f) - (high - low);
    if (missing <= 0)
        return {low, high};
    return {low - missing / 2, high + missing / 2};
}

void line(ImVec2 a, ImVec2 b, ImU32 color) {
    ImGui::GetBackgroundDrawList()->AddLine(a, b, color, LINE_WIDTH * scale);
}

void plate(ImVec2 low, ImVec2 size) {
    ImGui::GetBackgroundDrawList()->AddRectFilled(low, ImVec2(low.x + size.x, low.y + size.y),
                                                  PLATE);
}

void text_right(float x, float y, ImU32 color, const char* words) {
    text(x - width_of(words), y, color, words);
}

// Right-aligned at x, on the line of a text that ends at `end`, if both fit.
void text_beside(float end, float x, float y, ImU32 color, const char* words) {
    if (end + GAP * scale + width_of(words) <= x)
        text_right(x, y, color, words);
}

void draw_plot(const LabPanel& panel, const LabPlot& plot, ImVec2 low, ImVec2 size) {
    const Range range = range_of(plot.y, panel.count);
    const Range time = range_of(panel.t, panel.count);
    plate(low, size);
    ImVec2 last;
    bool drawn = false;
    for (int k = 0; k < panel.count; k++) {
        const ImVec2 at(low.x + size.x * time.fraction(panel.t[k]),
                        low.y + size.y * (1 - range.fraction(plot.y[k])));
        const bool good = std::isfinite(plot.y[k]);
        if (good && drawn)
            line(last, at, LINE_COLOR);
        last = at;
        drawn = good;
    }
}

void draw_plot_text(const LabPanel& panel, const LabPlot& plot, float left, float right, float y) {
    char ends[64];
    const float x = left + LABEL_WIDTH * scale;
    const Range range = range_of(plot.y, panel.count);
    std::snprintf(ends, sizeof ends, "%.3g to %.3g", static_cast<double>(range.low),
                  static_cast<double>(range.high));
    text(left, y, LABEL, plot.label);
    text(x, y, VALUE, plot.value);
    const bool flat = range.high - range.low <=
                      FLAT * std::max(std::fabs(range.low), std::fabs(range.high)) * 1.01f;
    if (!flat)
        text_beside(x + width_of(plot.value), right, y, LABEL, ends);
}

void draw_times(const LabPanel& panel, float left, float right, float y) {
    char words[32];
    if (panel.count == 0)
        return;
    std::snprintf(words, sizeof words, "%.4g s", static_cast<double>(panel.t[0]));
    text(left, y, LABEL, words);
    std::snprintf(words, sizeof words, "%.4g s", static_cast<double>(panel.t[panel.count - 1]));
    text_right(right, y, LABEL, words);
}

void draw_curve(const LabCurve& curve, ImVec2 low, ImVec2 size) {
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const auto at = [&](float l, float p) {
        return ImVec2(low.x + size.x * (l - 1) / (curve.stretch - 1),
                      low.y + size.y * (1 - p / curve.pressure));
    };
    plate(low, size);
    list->PushClipRect(low, ImVec2(low.x + size.x, low.y + size.y), true);
    for (int k = 1; k < LAB_CURVE; k++) {
        const float step = (curve.stretch - 1) / (LAB_CURVE - 1);
        line(at(1 + step * static_cast<float>(k - 1), curve.truth[k - 1]),
             at(1 + step * static_cast<float>(k), curve.truth[k]), TRUTH);
    }
    for (int k = 1; k < curve.count; k++)
        line(at(curve.path[k - 1][0], curve.path[k - 1][1]), at(curve.path[k][0], curve.path[k][1]),
             LINE_COLOR);
    list->PopClipRect();
    if (curve.count == 0)
        return;
    const float* now = curve.path[curve.count - 1];
    const ImVec2 dot = at(now[0], now[1]);
    list->AddCircleFilled(
        ImVec2(std::clamp(dot.x, low.x, low.x + size.x), std::clamp(dot.y, low.y, low.y + size.y)),
        DOT * scale, VALUE);
}

// A grid of cells. Lines through the rows' middles: the limit of theory solid, the bound dashed.
void draw_map(const LabMap& map, ImVec2 low, ImVec2 size) {
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const ImVec2 cell(size.x / LAB_COLUMNS, size.y / LAB_ROWS);
    const auto corner = [&](int row, int column) {
        return ImVec2(low.x + cell.x * static_cast<float>(column),
                      low.y + cell.y * static_cast<float>(LAB_ROWS - 1 - row));
    };
    plate(low, size);
    for (int r = 0; r < LAB_ROWS; r++)
        for (int c = 0; c < LAB_COLUMNS; c++) {
            const ImVec2 at = corner(r, c);
            if (map.cell[r][c] != LAB_UNKNOWN)
                list->AddRectFilled(at, ImVec2(at.x + cell.x - scale, at.y + cell.y - scale),
                                    CELL[map.cell[r][c]]);
        }

    list->PushClipRect(low, ImVec2(low.x + size.x, low.y + size.y), true);
    const auto middle = [&](int row, float column) {
        return ImVec2(low.x + cell.x * (column + 0.5f), corner(row, 0).y + cell.y / 2);
    };
    for (int r = 1; r < LAB_ROWS; r++) {
        if (std::isfinite(map.theory[r - 1] + map.theory[r]))
            line(middle(r - 1, map.theory[r - 1]), middle(r, map.theory[r]), EDGE);
        const ImVec2 a = middle(r - 1, map.bound[r - 1]), b = middle(r, map.bound[r]);
        if (std::isfinite(a.x + b.x))
            line(a, ImVec2((a.x + b.x) / 2, (a.y + b.y) / 2), EDGE);
    }
    list->PopClipRect();

    const ImVec2 own = middle(map.own[0], static_cast<float>(map.own[1]));
    list->AddCircleFilled(own, DOT * scale / 2, EDGE);
    const ImVec2 at = corner(map.chosen[0], map.chosen[1]);
    list->AddRect(ImVec2(at.x - scale, at.y - scale), ImVec2(at.x + cell.x, at.y + cell.y),
                  map.watched ? TITLE : VALUE, 0, 0, 2 * scale);
}

// Positions, in pixels of the picture.
struct Layout {
    float left, right, width; // of texts and plots
    float plot_height;        // height of a plot
    float curve, map, end;    // y at which these begin
};

// Texts have fixed heights; plots, curve and map share the rest.
Layout layout_of(const LabPanel& panel, ImVec2 size) {
    Layout layout;
    layout.width = std::min(MAX_WIDTH * scale, MAX_SHARE * size.x);
    layout.right = size.x - (MARGIN + PADDING) * scale;
    layout.left = layout.right - layout.width;
    const float plots = static_cast<float>(panel.plot_count);
    const float curve = panel.has_curve ? 1.0f : 0.0f;
    const float lines = TITLE_LINES + plots + AXIS_LINES + curve * (1 + AXIS_LINES) + 3;
    const float parts = plots + CURVE_PLOTS * (curve + 1);
    const float rest = size.y - (2 * MARGIN + 2 * PADDING + lines * LINE) * scale;
    layout.plot_height = std::clamp(rest / parts, MIN_PLOT_HEIGHT * scale, PLOT_HEIGHT * scale);
    layout.curve = (MARGIN + PADDING) * scale + (TITLE_LINES + plots + AXIS_LINES) * LINE * scale +
                   plots * layout.plot_height;
    layout.map =
        layout.curve + curve * ((1 + AXIS_LINES) * LINE * scale + CURVE_PLOTS * layout.plot_height);
    layout.end = layout.map + 3 * LINE * scale + CURVE_PLOTS * layout.plot_height + PADDING * scale;
    return layout;
}

ImVec2 map_low(const Layout& layout) {
    return ImVec2(layout.left, layout.map + LINE * scale);
}

ImVec2 map_size(const Layout& layout) {
    return ImVec2(layout.width, CURVE_PLOTS * layout.plot_height - 4 * scale);
}

void draw_curve_part(const LabCurve& curve, const Layout& layout) {
    char end[32];
    const float height = CURVE_PLOTS * layout.plot_height;
    float y = layout.curve;
    const char* title = "Pressure over stretch";
    text(layout.left, y, TITLE, title);
    text_beside(layout.left + width_of(title), layout.right, y, TRUTH, curve.law);
    y += LINE * scale;
    draw_curve(curve, ImVec2(layout.left, y), ImVec2(layout.width, height - 4 * scale));
    y += height;
    std::snprintf(end, sizeof end, "%.3g", static_cast<double>(curve.stretch));
    text(layout.left, y, VALUE, curve.value);
    text_beside(layout.left + width_of(curve.value), layout.right, y, LABEL, end);
}

void draw_map_part(const LabMap& map, const Layout& layout) {
    float y = layout.map;
    const char* title = "Stability: step, stiffness";
    text(layout.left, y, TITLE, title);
    text_beside(layout.left + width_of(title), layout.right, y, LABEL, map.method);
    draw_map(map, map_low(layout), map_size(layout));
    y += LINE * scale + CURVE_PLOTS * layout.plot_height;
    text(layout.left, y, LABEL, map.ends);
    y += LINE * scale;
    text(layout.left, y, VALUE, map.why[0] ? map.why : map.value);
}

} // namespace

float draw_lab_panel(const LabPanel& panel, ImVec2 size) {
    const Layout layout = layout_of(panel, size);
    const float left = layout.left, right = layout.right;
    box(ImVec2(left - PADDING * scale, MARGIN * scale),
        ImVec2(layout.width + 2 * PADDING * scale, layout.end - MARGIN * scale), GLASS);

    float y = (MARGIN + PADDING) * scale;
    text(left, y, TITLE, panel.title);
    y += TITLE_LINES * LINE * scale;
    for (int k = 0; k < panel.plot_count; k++) {
        draw_plot_text(panel, panel.plot[k], left, right, y);
        y += LINE * scale;
        draw_plot(panel, panel.plot[k], ImVec2(left, y),
                  ImVec2(layout.width, layout.plot_height - 4 * scale));
        y += layout.plot_height;
    }
    draw_times(panel, left, right, y);
    if (panel.has_curve)
        draw_curve_part(panel.curve, layout);
    draw_map_part(panel.map, layout);
    return left - PADDING * scale;
}

bool lab_panel_cell(const LabPanel& panel, ImVec2 size, ImVec2 point, int cell[2]) {
    const Layout layout = layout_of(panel, size);
    const ImVec2 low = map_low(layout), area = map_size(layout);
    const float across = (point.x - low.x) / area.x, down = (point.y - low.y) / area.y;
    if (!(across >= 0 && across < 1 && down >= 0 && down < 1))
        return false;
    cell[0] = LAB_ROWS - 1 - static_cast<int>(down * LAB_ROWS);
    cell[1] = static_cast<int>(across * LAB_COLUMNS);
    return true;
}

} // namespace hud
