#include "view/panel.h"

#include <stdarg.h>
#include <stdio.h>

void panel_row(Panel* panel, const char* label, const char* format, ...) {
    if (panel->row_count >= PANEL_ROWS)
        return;
    PanelRow* row = &panel->row[panel->row_count++];
    snprintf(row->label, sizeof row->label, "%s", label);

    va_list arguments;
    va_start(arguments, format);
    vsnprintf(row->value, sizeof row->value, format, arguments);
    va_end(arguments);
}

void panel_text(char* text, size_t size, const char* from) {
    snprintf(text, size, "%s", from);
}
