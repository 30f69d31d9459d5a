#include "hud/hud.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <imgui.h>
#include <backends/imgui_impl_opengl3.h>

#include "hud/parts.hpp"

using namespace hud;

namespace hud {

float scale = 1;

float width_of(const char* text) {
    return ImGui::CalcTextSize(text).x;
}

void box(ImVec2 low, ImVec2 size, ImU32 color) {
    ImGui::GetBackgroundDrawList()->AddRectFilled(low, ImVec2(low.x + size.x, low.y + size.y),
                                                  color, ROUND * scale);
}

void text(float x, float y, ImU32 color, const char* words) {
    ImGui::GetBackgroundDrawList()->AddText(ImVec2(x, y), color, words);
}

} // namespace hud

// The boxes are laid out here and drawn as shapes and text, not as ImGui windows: the size of such
// a window depends on the previous frame, so two pictures of one overlay would differ.
namespace {

/// Two columns of text under a title.
struct Table {
    const char* title;
    int count;
    const char* (*label)(const Overlay& overlay, int i);
    const char* (*value)(const Overlay& overlay, int i);
};

const char* row_label(const Overlay& overlay, int i) {
    return overlay.row[i].label;
}

const char* row_value(const Overlay& overlay, int i) {
    return overlay.row[i].value;
}

const char* key_label(const Overlay& overlay, int i) {
    return overlay.key[i].key;
}

const char* key_value(const Overlay& overlay, int i) {
    return overlay.key[i].about;
}

constexpr float MIN_VALUE_WIDTH = 80; // of the column of values
constexpr float MIN_LINE = 11;        // line height of a table with many rows
constexpr float TITLE_LINES = 1.4f;   // height of a title, in lines

// End of the words that fit on a line of this width, at least one word; ImGui's own wrapping would
// break numbers at their decimal points.
const char* line_end(const char* words, float width) {
    const char* end = words + std::strcspn(words, " ");
    while (*end) {
        const char* next = end + 1 + std::strcspn(end + 1, " ");
        if (ImGui::CalcTextSize(words, next).x > width)
            break;
        end = next;
    }
    return end;
}

// The height of a wrapped text's lines after the first.
float wrapped_height(const char* words, float width) {
    float height = 0;
    while (*(words = line_end(words, width)) != 0) {
        words++;
        height += FONT_SIZE * scale;
    }
    return height;
}

void text_wrapped(float x, float y, ImU32 color, const char* words, float width) {
    for (const char* end; *words; words = *end ? end + 1 : end, y += FONT_SIZE * scale) {
        end = line_end(words, width);
        ImGui::GetBackgroundDrawList()->AddText(ImVec2(x, y), color, words, end);
    }
}

// Draw a table at the left or the right edge of a picture of this size. Long texts are wrapped to
// `max_width`; a table that does not fit is left out. Returns the box's left end.
float draw_table(const Overlay& overlay, const Table& table, ImVec2 size, bool right,
                 float max_width) {
    float labels = 0, values = 0;
    for (int i = 0; i < table.count; i++) {
        labels = std::max(labels, width_of(table.label(overlay, i)));
        values = std::max(values, width_of(table.value(overlay, i)));
    }
    const float inner = max_width - 2 * PADDING * scale, before = labels + GAP * scale;
    const float value_width = std::min(values, inner - before);
    if (value_width < std::min(values, MIN_VALUE_WIDTH * scale))
        return size.x;
    const float columns = table.count > 0 ? before + value_width : 0;
    const float words = std::max(columns, std::min(width_of(table.title), inner));
    const float width = words + 2 * PADDING * scale;
    const float head = TITLE_LINES * LINE * scale + wrapped_height(table.title, words);
    const float rest = size.y - (2 * MARGIN + 1.5f * PADDING) * scale - head;
    const float line =
        std::clamp(rest / static_cast<float>(table.count), MIN_LINE * scale, LINE * scale);
    float height = head + 1.5f * PADDING * scale;
    for (int i = 0; i < table.count; i++)
        height += line + wrapped_height(table.value(overlay, i), value_width);
    const ImVec2 low(right ? size.x - MARGIN * scale - width : MARGIN * scale, MARGIN * scale);
    box(low, ImVec2(width, height), GLASS);

    const float left = low.x + PADDING * scale;
    float y = low.y + PADDING * scale;
    text_wrapped(left, y, TITLE, table.title, words);
    y += head;
    for (int i = 0; i < table.count; i++) {
        const char* value = table.value(overlay, i);
        text(left, y, LABEL, table.label(overlay, i));
        text_wrapped(left + before, y, VALUE, value, value_width);
        y += line + wrapped_height(value, value_width);
    }
    return low.x;
}

// The message, wrapped, at the middle of the lower edge.
void draw_message(const Overlay& overlay, ImVec2 size) {
    const float max_width =
        std::max(size.x - 4 * (MARGIN + PADDING) * scale, 10 * FONT_SIZE * scale);
    const ImVec2 words = ImGui::CalcTextSize(overlay.message, nullptr, false, max_width);
    const ImVec2 area(words.x + 2.5f * PADDING * scale, words.y + 1.6f * PADDING * scale);
    const ImVec2 low(0.5f * (size.x - area.x), size.y - 2 * MARGIN * scale - area.y);
    box(low, area, overlay.alarm ? ALARM : GLASS);
    ImGui::GetBackgroundDrawList()->AddText(
        ImGui::GetFont(), ImGui::GetFontSize(),
        ImVec2(low.x + 1.25f * PADDING * scale, low.y + 0.8f * PADDING * scale), VALUE,
        overlay.message, nullptr, max_width);
}

} // namespace

bool hud_open(float requested_scale, Fault* fault) {
    // ImGui's own font is a bitmap: only whole multiples are crisp
    scale = std::max(1.0f, std::round(requested_scale));
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();

    // without files and clock, so that the same overlay gives the same pixels
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.DeltaTime = 1.0f / 60;

    ImFontConfig font;
    font.SizePixels = FONT_SIZE * scale;
    io.Fonts->AddFontDefault(&font);

    if (ImGui_ImplOpenGL3_Init("#version 330 core"))
        return true;
    ImGui::DestroyContext();
    return fault_set(fault, "overlay", "Dear ImGui cannot load OpenGL: apt-get install libgl1");
}

void hud_draw(const Overlay* overlay, int width, int height) {
    const ImVec2 size(static_cast<float>(width), static_cast<float>(height));
    ImGui::GetIO().DisplaySize = size;
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();

    // the status box takes the width that the other box leaves
    const float all = size.x - MARGIN * scale;
    float free = all;
    if (overlay->help_visible)
        free = draw_table(*overlay, {"Keys", overlay->key_count, key_label, key_value}, size, true,
                          all - MARGIN * scale);
    else if (overlay->lab_panel)
        free = draw_lab_panel(*overlay->lab_panel, size);
    if (overlay->status_visible)
        draw_table(*overlay, {overlay->title, overlay->row_count, row_label, row_value}, size,
                   false, std::min(free - 0.5f * MARGIN * scale, all) - MARGIN * scale);
    if (overlay->lab_panel)
        draw_slider(overlay->lab_panel->slider, size);
    if (overlay->message[0])
        draw_message(*overlay, size);

    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool hud_cell(const Overlay* overlay, int width, int height, const float point[2], int cell[2]) {
    const ImVec2 size(static_cast<float>(width), static_cast<float>(height));
    return overlay->lab_panel && !overlay->help_visible &&
           lab_panel_cell(*overlay->lab_panel, size, ImVec2(point[0] * size.x, point[1] * size.y),
                          cell);
}

int hud_notch(const Overlay* overlay, int width, int height, const float point[2]) {
    const ImVec2 size(static_cast<float>(width), static_cast<float>(height));
    if (!overlay->lab_panel)
        return 0;
    return slider_notch(overlay->lab_panel->slider, size,
                        ImVec2(point[0] * size.x, point[1] * size.y));
}

void hud_close(void) {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
}
