#include "draw/shader.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw/frame.h"

enum { PATH = 512, FILES = 3 };

/// The source of one shader: a version line, then the text of several files.
typedef struct Source {
    int count;
    char path[FILES][PATH];
    char* text[FILES];
} Source;

// The text of a file after a #line directive, so that compiler messages name the file by `number`.
static char* read_file(const char* path, int number, Fault* fault) {
    FILE* file = fopen(path, "rb");
    if (!file) {
        fault_set(fault, path, "cannot open this shader (%s)", strerror(errno));
        return NULL;
    }

    char* text = NULL;
    long size = -1;
    if (fseek(file, 0, SEEK_END) == 0 && (size = ftell(file)) >= 0)
        text = malloc((size_t)size + 32);
    if (text) {
        rewind(file);
        const int head = sprintf(text, "#line 1 %d\n", number);
        const size_t length = fread(text + head, 1, (size_t)size, file);
        text[head + (int)length] = 0;
    } else {
        fault_set(fault, path, "cannot read this shader");
    }
    fclose(file);
    return text;
}

static bool append(Source* source, const char* dir, const char* name, Fault* fault) {
    const int i = source->count++;
    snprintf(source->path[i], PATH, "%s/%s", dir, name);
    source->text[i] = read_file(source->path[i], i, fault);
    return source->text[i] != NULL;
}

// Mesa prints "2:17(5): error: …", other drivers "2(17) : error …": file number, line, message.
static void compile_fault(GLuint shader, const Source* source, Fault* fault) {
    char log[1024] = "";
    glGetShaderInfoLog(shader, sizeof log, NULL, log);

    int number = 0, line = 0;
    if (sscanf(log, "%d:%d", &number, &line) != 2 && sscanf(log, "%d(%d)", &number, &line) != 2)
        number = source->count - 1;
    if (number < 0 || number >= source->count)
        number = source->count - 1;
    fault_at(fault, source->path[number], line, "%s", log);
}

static GLuint compile(GLenum stage, const Source* source, Fault* fault) {
    const char* text[FILES + 1] = {"#version 330 core\n"};
    for (int i = 0; i < source->count; i++)
        text[i + 1] = source->text[i];

    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, source->count + 1, text, NULL);
    glCompileShader(shader);

    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled)
        return shader;
    compile_fault(shader, source, fault);
    glDeleteShader(shader);
    return 0;
}

static GLuint stage_load(GLenum stage, const char* dir, const char* name, Fault* fault) {
    Source source = {.count = 0};
    const bool read = append(&source, dir, "frame.glsl", fault) &&
                      append(&source, dir, "studio.glsl", fault) &&
                      append(&source, dir, name, fault);

    const GLuint shader = read ? compile(stage, &source, fault) : 0;
    for (int i = 0; i < source.count; i++)
        free(source.text[i]);
    return shader;
}

static GLuint link_stages(GLuint vertex, GLuint fragment, const char* file, Fault* fault) {
    const GLuint program = glCreateProgram();
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    glLinkProgram(program);

    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked) {
        char log[1024] = "";
        glGetProgramInfoLog(program, sizeof log, NULL, log);
        fault_set(fault, file, "shaders do not link: %s", log);
        glDeleteProgram(program);
        return 0;
    }

    const GLuint block = glGetUniformBlockIndex(program, "Frame");
    if (block != GL_INVALID_INDEX)
        glUniformBlockBinding(program, block, FRAME_BINDING);
    return program;
}

GLuint shader_load(const char* dir, const char* vertex, const char* fragment, Fault* fault) {
    const GLuint first = stage_load(GL_VERTEX_SHADER, dir, vertex, fault);
    const GLuint second = first ? stage_load(GL_FRAGMENT_SHADER, dir, fragment, fault) : 0;
    const GLuint program = second ? link_stages(first, second, fragment, fault) : 0;

    // a linked program does not need its shaders; glDeleteShader ignores 0
    glDeleteShader(first);
    glDeleteShader(second);
    return program;
}
