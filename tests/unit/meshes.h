/// Meshes for tests: by name, by hand, and from the text of an OBJ file.
#ifndef BALLOON_TESTS_MESHES_H
#define BALLOON_TESTS_MESHES_H

#include <unistd.h>

#include "base/memory.h"
#include "base/random.h"
#include "law.h"
#include "mesh/doctor.h"
#include "mesh/load.h"

/// A mesh that must be usable.
static inline MeshReport load(const char* name, Mesh* mesh) {
    MeshReport report;
    Fault fault = {0};
    if (!mesh_load(name, mesh, &report, &fault))
        fail_msg("%s: %s", fault.location, fault.text);
    return report;
}

/// A file in a new folder under /tmp; unlink_text removes both.
typedef struct TextFile {
    char folder[32];
    char path[64];
} TextFile;

static inline TextFile write_bytes(const char* name, const void* bytes, size_t size) {
    TextFile file = {.folder = "/tmp/balloon-XXXXXX"};
    if (!mkdtemp(file.folder))
        fail_msg("no folder in /tmp");
    snprintf(file.path, sizeof file.path, "%s/%s", file.folder, name);
    FILE* out = fopen(file.path, "wb");
    assert_non_null(out);
    assert_int_equal(fwrite(bytes, 1, size, out), size);
    fclose(out);
    return file;
}

static inline void remove_file(const TextFile* file) {
    unlink(file->path);
    rmdir(file->folder);
}

/// Load a mesh from the text of an OBJ file. The fault's location is the path.
static inline bool load_text(const char* text, Mesh* mesh, MeshReport* report, Fault* fault) {
    const TextFile file = write_bytes("mesh.obj", text, strlen(text));
    const bool good = mesh_load(file.path, mesh, report, fault);
    remove_file(&file);
    return good;
}

/// The text of a mesh that must be usable.
static inline MeshReport load_good(const char* text, Mesh* mesh) {
    MeshReport report;
    Fault fault = {0};
    if (!load_text(text, mesh, &report, &fault))
        fail_msg("%s: %s", fault.location, fault.text);
    return report;
}

/// The text must be refused with this location (after the folder) and these words in the sentence.
static inline void refuse_text(const char* text, const char* location, const char* words) {
    Mesh mesh;
    MeshReport report;
    Fault fault = {0};
    if (load_text(text, &mesh, &report, &fault))
        fail_msg("this was loaded, want it refused: %s", text);
    const char* slash = strrchr(fault.location, '/');
    if (!slash || strcmp(slash + 1, location) != 0 || !strstr(fault.text, words))
        fail_msg("got \"%s: %s\", want location %s and \"%s\"", fault.location, fault.text,
                 location, words);
    mesh_free(&mesh);
}

/// Rest positions as a state.
static inline real4* rest_state(const Mesh* mesh) {
    real4* x = new_array(real4, mesh->point_count);
    for (int i = 0; i < mesh->point_count; i++)
        x[i] = to_real4(mesh->point[i]);
    return x;
}

/// The cube of side 2 as OBJ text, its faces outward.
#define CUBE_POINTS                                                                                \
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
#define CUBE_FACES "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"

#endif
