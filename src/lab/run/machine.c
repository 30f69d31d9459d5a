#include "lab/run/machine.h"

#include <stdio.h>

#ifdef __clang__
#define COMPILER "clang " __clang_version__
#else
#define COMPILER "gcc " __VERSION__
#endif

const char* machine_name(void) {
    static char machine[256];
    char line[256], name[128] = "a machine that does not tell its name";
    FILE* about = fopen("/proc/cpuinfo", "r");
    while (about && fgets(line, sizeof line, about))
        if (sscanf(line, "model name : %127[^\n]", name) == 1)
            break;
    if (about)
        fclose(about);
    snprintf(machine, sizeof machine, "%s, " COMPILER, name);
    return machine;
}
