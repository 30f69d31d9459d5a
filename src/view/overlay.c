#include "view/overlay.h"

#include <stdarg.h>
#include <stdio.h>

void overlay_row(Overlay* overlay, const char* label, const char* format, ...) {
    if (overlay->row_count >= OVERLAY_ROWS)
        return;
    OverlayRow* row = &overlay->row[overlay->row_count++];
    snprintf(row->label, sizeof row->label, "%s", label);

    va_list arguments;
    va_start(arguments, format);
    vsnprintf(row->value, sizeof row->value, format, arguments);
    va_end(arguments);
}

void overlay_text(char* text, size_t size, const char* from) {
    snprintf(text, size, "%s", from);
}
