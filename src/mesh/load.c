#include "mesh/load.h"

#include <string.h>
#include <strings.h>
#include <unistd.h>

#include <assimp/cimport.h>
#include <assimp/scene.h>

#include "mesh/obj.h"
#include "mesh/shape.h"

/// The source's faces are those of the scene, whose corners carry their vertex's number as x.
static bool take_faces(MeshSource* source, const struct aiScene* scene) {
    int count = 0;
    for (unsigned m = 0; m < scene->mNumMeshes; m++) {
        const struct aiMesh* part = scene->mMeshes[m];
        for (unsigned f = 0; f < part->mNumFaces; f++) {
            const struct aiFace* face = &part->mFaces[f];
            if (count == source->face_count || face->mNumIndices < 3 || face->mNumIndices > 4)
                return false;
            source->face[count][3] = NONE;
            for (unsigned k = 0; k < face->mNumIndices; k++)
                source->face[count][k] = (int)part->mVertices[face->mIndices[k]].x;
            count++;
        }
    }
    return count == source->face_count;
}

/// Let assimp resolve the faces of the plain text.
static bool import_faces(MeshSource* source, const ObjText* obj, Fault* fault) {
    const struct aiScene* scene = aiImportFileFromMemory(obj->text, (unsigned)obj->size, 0, "obj");
    if (!scene) {
        if (obj_check_corners(obj, source, fault))
            fault_set(fault, source->name, "assimp cannot read it: %s", aiGetErrorString());
        return false;
    }
    const bool good = take_faces(source, scene);
    aiReleaseImport(scene);
    if (!good)
        fault_set(fault, source->name, "assimp does not give back the faces that the file has");
    return good;
}

static bool load_file(const char* path, MeshSource* source, Fault* fault) {
    ObjText obj;
    if (!obj_read(&obj, source, path, fault))
        return false;
    const bool good = import_faces(source, &obj, fault);
    obj_free(&obj);
    if (!good)
        source_free(source);
    return good;
}

static bool is_obj(const char* name) {
    const char* dot = strrchr(name, '.');
    return dot && strcasecmp(dot, ".obj") == 0;
}

/// What is neither a shape nor an .obj file.
static bool refuse_name(const char* name, Fault* fault) {
    if (access(name, F_OK) == 0)
        return fault_set(fault, name,
                         "is not an .obj file; convert it with Blender or a similar program");
    char shapes[256] = "";
    for (int i = 0; i < shape_count; i++) {
        const size_t length = strlen(shapes);
        snprintf(shapes + length, sizeof shapes - length, "%s%s", i ? ", " : "",
                 shape_table[i].name);
    }
    return fault_set(fault, name, "there is no such file and no such shape; there are %s", shapes);
}

bool mesh_load(const char* name, Mesh* mesh, MeshReport* report, Fault* fault) {
    *mesh = (Mesh){0};
    *report = (MeshReport){0};
    MeshSource source;
    if (shape_find(name)) {
        if (!shape_make(name, &source, fault))
            return false;
    } else if (!is_obj(name)) {
        return refuse_name(name, fault);
    } else if (!load_file(name, &source, fault)) {
        return false;
    }

    const bool usable = doctor_treat(&source, mesh, report);
    source_free(&source);
    if (!usable)
        *fault = report->unusable;
    return usable;
}
