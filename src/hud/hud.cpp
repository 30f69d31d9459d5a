#include "hud/hud.h"

#include <algorithm>
#include <cmath>

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

// The boxes are laid out here and drawn as shapes and text, not as ImGui windows: those learn
// their size from the frame before, so that two pictures of one panel would differ.
namespace {

/// Two columns of text under a title, as wide as they need.
struct Table {
    const char* title;
    int count;
    const char* (*label)(const Panel& panel, int i);
    const char* (*value)(const Panel& panel, int i);
};

const char* row_label(const Panel& panel, int i) {
    return panel.row[i].label;
}

const char* row_value(const Panel& panel, int i) {
    return panel.row[i].value;
}

const char* key_label(const Panel& panel, int i) {
    return panel.key[i].key;
}

const char* key_value(const Panel& panel, int i) {
    return panel.key[i].about;
}

// right: the box ends at x, otherwise it begins there.
void draw_table(const Panel& panel, const Table& table, float x, bool right) {
    float labels = 0, values = 0;
    for (int i = 0; i < table.count; i++) {
        labels = std::max(labels, width_of(table.label(panel, i)));
        values = std::max(values, width_of(table.value(panel, i)));
    }
    const float columns = table.count > 0 ? labels + GAP * scale + values : 0;
    const float wide = std::max(columns, width_of(table.title)) + 2 * PADDING * scale;
    const float lines = static_cast<float>(table.count) + 1.4f;
    const ImVec2 low(right ? x - wide : x, MARGIN * scale);
    box(low, ImVec2(wide, lines * LINE * scale + 1.5f * PADDING * scale), GLASS);

    const float left = low.x + PADDING * scale;
    float y = low.y + PADDING * scale;
    text(left, y, TITLE, table.title);
    y += 1.4f * LINE * scale;
    for (int i = 0; i < table.count; i++, y += LINE * scale) {
        text(left, y, LABEL, table.label(panel, i));
        text(left + labels + GAP * scale, y, VALUE, table.value(panel, i));
    }
}

// A sentence in the middle of the lower rim, on as many lines as it takes.
void draw_message(const Panel& panel, ImVec2 size) {
    const float widest = std::max(size.x - 4 * (MARGIN + PADDING) * scale, 10 * FONT_SIZE * scale);
    const ImVec2 words = ImGui::CalcTextSize(panel.message, nullptr, false, widest);
    const ImVec2 whole(words.x + 2.5f * PADDING * scale, words.y + 1.6f * PADDING * scale);
    const ImVec2 low(0.5f * (size.x - whole.x), size.y - 2 * MARGIN * scale - whole.y);
    box(low, whole, panel.alarm ? ALARM : GLASS);
    ImGui::GetBackgroundDrawList()->AddText(
        ImGui::GetFont(), ImGui::GetFontSize(),
        ImVec2(low.x + 1.25f * PADDING * scale, low.y + 0.8f * PADDING * scale), VALUE,
        panel.message, nullptr, widest);
}

} // namespace

bool hud_open(float asked, Fault* fault) {
    // ImGui's own font is made of pixels: only whole multiples are crisp
    scale = std::max(1.0f, std::round(asked));
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();

    // no file is read or written, and no clock: the same panel gives the same pixels
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

void hud_draw(const Panel* panel, int width, int height) {
    const ImVec2 size(static_cast<float>(width), static_cast<float>(height));
    ImGui::GetIO().DisplaySize = size;
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();

    if (panel->shown)
        draw_table(*panel, {panel->title, panel->row_count, row_label, row_value}, MARGIN * scale,
                   false);
    if (panel->help_shown)
        draw_table(*panel, {"Keys", panel->key_count, key_label, key_value},
                   size.x - MARGIN * scale, true);
    else if (panel->page)
        draw_page(*panel->page, size);
    if (panel->page)
        draw_slider(panel->page->slider, size);
    if (panel->message[0])
        draw_message(*panel, size);

    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool hud_cell(const Panel* panel, int width, int height, const float point[2], int cell[2]) {
    const ImVec2 size(static_cast<float>(width), static_cast<float>(height));
    return panel->page && !panel->help_shown &&
           page_cell(*panel->page, size, ImVec2(point[0] * size.x, point[1] * size.y), cell);
}

int hud_notch(const Panel* panel, int width, int height, const float point[2]) {
    const ImVec2 size(static_cast<float>(width), static_cast<float>(height));
    if (!panel->page)
        return 0;
    return slider_notch(panel->page->slider, size, ImVec2(point[0] * size.x, point[1] * size.y));
}

void hud_close(void) {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
}
