/// The shipped scenes: all .yaml files below assets/scenes.
#include "scene/scene.h"

#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/array.h"
#include "base/memory.h"
#include "base/paths.h"

static bool is_scene(const char* path) {
    const char* dot = strrchr(path, '.');
    return dot && strcmp(dot, ".yaml") == 0;
}

void scene_name(const char* path, char name[256]) {
    Fault unused = {0};
    char folder[512];
    const size_t length = paths_own("assets", "scenes", folder, &unused) ? strlen(folder) : 0;
    const bool shipped = length > 0 && strncmp(path, folder, length) == 0 && path[length] == '/';
    snprintf(name, 256, "%s", shipped ? path + length + 1 : path);
    if (is_scene(name))
        *strrchr(name, '.') = '\0';
}

typedef struct List {
    char** path;
    int count;
    int capacity;
} List;

static void list_add(List* list, const char* path) {
    array_reserve(list->path, list->count, list->capacity);
    list->path[list->count] = new_array(char, strlen(path) + 1);
    strcpy(list->path[list->count++], path);
}

static void list_folder(List* list, const char* folder) {
    DIR* entries = opendir(folder);
    if (!entries)
        return;
    const struct dirent* entry;
    while ((entry = readdir(entries))) {
        char path[512];
        const int length = snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        struct stat about;
        if (entry->d_name[0] == '.' || length >= (int)sizeof path || stat(path, &about) != 0)
            continue;
        if (S_ISDIR(about.st_mode))
            list_folder(list, path);
        else if (is_scene(path))
            list_add(list, path);
    }
    closedir(entries);
}

static int by_name(const void* a, const void* b) {
    return strcmp(*(char* const*)a, *(char* const*)b);
}

int scene_list(char*** path) {
    List list = {.path = new_array(char*, 1)};
    Fault unused = {0};
    char folder[512];
    if (paths_own("assets", "scenes", folder, &unused))
        list_folder(&list, folder);
    qsort(list.path, (size_t)list.count, sizeof *list.path, by_name);
    *path = list.path;
    return list.count;
}
