#include "lab/run/overrides.h"

#include <stdarg.h>

#include "base/fault.h"

void overrides_add(Overrides* sets, const char* format, ...) {
    ASSERT(sets->count < MAX_OVERRIDES, "there is room for the overrides");
    va_list list;
    va_start(list, format);
    vsnprintf(sets->text[sets->count++], sizeof sets->text[0], format, list);
    va_end(list);
}
