#include "mesh/import.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include <assimp/cimport.h>
#include <assimp/scene.h>

#include "mesh/bounded.h"
#include "mesh/file.h"
#include "mesh/mesh.h"

/// x' = linear x + move, by columns.
typedef struct Transform {
    double4 column[3];
    double4 move;
} Transform;

typedef struct Import {
    const struct aiScene* scene;
    MeshSource* source; ///< filled up to its counts
    Fault* fault;
} Import;

static double4 apply(const Transform* t, double4 p) {
    return t->column[0] * p[0] + t->column[1] * p[1] + t->column[2] * p[2];
}

/// The transform of a node, within that of its parent.
static Transform compose(const Transform* parent, const struct aiMatrix4x4* m) {
    return (Transform){
        .column = {apply(parent, (double4){m->a1, m->b1, m->c1}),
                   apply(parent, (double4){m->a2, m->b2, m->c2}),
                   apply(parent, (double4){m->a3, m->b3, m->c3})},
        .move = parent->move + apply(parent, (double4){m->a4, m->b4, m->c4}),
    };
}

/// Points and faces of a node and all below it: one mesh counts as often as a node refers to it.
static void count_node(const struct aiScene* scene, const struct aiNode* node, long* points,
                       long* faces) {
    for (unsigned m = 0; m < node->mNumMeshes; m++) {
        *points += scene->mMeshes[node->mMeshes[m]]->mNumVertices;
        *faces += scene->mMeshes[node->mMeshes[m]]->mNumFaces;
    }
    for (unsigned k = 0; k < node->mNumChildren; k++)
        count_node(scene, node->mChildren[k], points, faces);
}

static bool add_points(Import* import, const struct aiMesh* mesh, const Transform* transform) {
    MeshSource* source = import->source;
    for (unsigned i = 0; i < mesh->mNumVertices; i++) {
        const struct aiVector3D v = mesh->mVertices[i];
        const double4 p = transform->move + apply(transform, (double4){v.x, v.y, v.z});
        if (!isfinite(p[0]) || !isfinite(p[1]) || !isfinite(p[2]))
            return fault_set(import->fault, source->name,
                             "vertex %d is not finite; a vertex needs a place",
                             source->point_count + 1);
        source->point[source->point_count++] = p;
    }
    return true;
}

static bool add_faces(Import* import, const struct aiMesh* mesh, int first_point) {
    MeshSource* source = import->source;
    for (unsigned f = 0; f < mesh->mNumFaces; f++) {
        const struct aiFace* face = &mesh->mFaces[f];
        const unsigned corners = face->mNumIndices;
        if (corners < 3 || corners > 4)
            return fault_set(
                import->fault, source->name,
                "face %d has %u corner%s; only quads and triangles can be balloons: %s",
                source->face_count + 1, corners, corners == 1 ? "" : "s",
                corners > 4 ? "split it" : "delete it");
        int* corner = source->face[source->face_count++];
        corner[3] = NONE;
        for (unsigned k = 0; k < corners; k++) {
            if (face->mIndices[k] >= mesh->mNumVertices)
                return fault_set(import->fault, source->name,
                                 "face %d names vertex %u, but there are only %u",
                                 source->face_count, face->mIndices[k] + 1, mesh->mNumVertices);
            corner[k] = first_point + (int)face->mIndices[k];
        }
    }
    return true;
}

static bool add_node(Import* import, const struct aiNode* node, const Transform* parent) {
    const Transform transform = compose(parent, &node->mTransformation);
    for (unsigned m = 0; m < node->mNumMeshes; m++) {
        const struct aiMesh* mesh = import->scene->mMeshes[node->mMeshes[m]];
        const int first_point = import->source->point_count;
        if (!add_points(import, mesh, &transform) || !add_faces(import, mesh, first_point))
            return false;
    }
    for (unsigned k = 0; k < node->mNumChildren; k++)
        if (!add_node(import, node->mChildren[k], &transform))
            return false;
    return true;
}

static bool take_scene(const struct aiScene* scene, MeshSource* source, const char* path,
                       Fault* fault) {
    long points = 0;
    long faces = 0;
    count_node(scene, scene->mRootNode, &points, &faces);
    if (!source_make_bounded(source, path, points, faces, fault))
        return false;
    source->point_count = 0;
    source->face_count = 0;

    const Transform identity = {.column = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    Import import = {.scene = scene, .source = source, .fault = fault};
    if (add_node(&import, scene->mRootNode, &identity))
        return true;
    source_free(source);
    return false;
}

static bool refuse_announced(const char* path, Fault* fault) {
    return fault_set(fault, path, "announces more than it can hold");
}

/// "OFF", or with prefixes as in "STCN4OFF", and the numbers of vertices, faces and edges.
static bool check_off(const FileText* file, const char* path, Fault* fault) {
    const char* at = file->text;
    while (isalnum((unsigned char)*at))
        at++;
    for (int number = 0; number < 3;) {
        if (*at == '#')
            at += strcspn(at, "\r\n");
        if (isdigit((unsigned char)*at)) {
            char* stop;
            if (strtoul(at, &stop, 10) > file->size)
                return refuse_announced(path, fault);
            at = stop;
            number++;
        } else if (isspace((unsigned char)*at)) {
            at++;
        } else {
            return fault_set(fault, path, "is not an OFF file: three counts begin it");
        }
    }
    return true;
}

/// "glTF", version and length; then the length of the JSON, in bytes 12 to 15, lowest first.
static bool check_glb(const FileText* file, const char* path, Fault* fault) {
    const unsigned char* byte = (const unsigned char*)file->text;
    if (file->size < 20 || memcmp(byte, "glTF", 4) != 0)
        return fault_set(fault, path, "is not a GLB file: 'glTF' begins it");
    const size_t json = byte[12] | byte[13] << 8 | byte[14] << 16 | (size_t)byte[15] << 24;
    return json <= file->size || refuse_announced(path, fault);
}

/// assimp allocates what these headers announce before it reads on.
static bool check_header(const char* path, Fault* fault) {
    const char* extension = strrchr(path, '.');
    FileText file;
    if (!file_read_bytes(&file, path, FILE_BYTES_MAX, fault))
        return false;
    bool good = true;
    if (strcasecmp(extension, ".off") == 0)
        good = check_off(&file, path, fault);
    else if (strcasecmp(extension, ".glb") == 0)
        good = check_glb(&file, path, fault);
    file_free(&file);
    return good;
}

/// By its path, not from memory: a glTF file may name others beside it.
static bool read_by_assimp(MeshSource* source, const char* path, Fault* fault) {
    const struct aiScene* scene = aiImportFile(path, 0);
    if (!scene)
        return fault_set(fault, path, "assimp cannot read it: %s", aiGetErrorString());
    const bool good = take_scene(scene, source, path, fault);
    aiReleaseImport(scene);
    return good;
}

bool import_read(MeshSource* source, const char* path, Fault* fault) {
    *source = (MeshSource){0};
    return check_header(path, fault) && bounded_read(read_by_assimp, source, path, fault);
}
