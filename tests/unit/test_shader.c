// Users may edit the shader files: a fault names the file and line of a mistake.
#include "law.h"

#include <unistd.h>

#include "draw/egl.h"
#include "draw/renderer.h"
#include "draw/shader.h"

static Egl egl;

static void the_shaders_compile(void** state) {
    (void)state;
    Fault fault = {0};
    const GLuint program = shader_load("shaders", "floor.vert", "floor.frag", &fault);
    assert_string_equal(fault.text, "");
    assert_int_not_equal(program, 0);
    glDeleteProgram(program);
}

static void a_missing_shader_is_named(void** state) {
    (void)state;
    Fault fault = {0};
    assert_int_equal(shader_load("no/such/folder", "floor.vert", "floor.frag", &fault), 0);
    assert_non_null(strstr(fault.location, "no/such/folder/frame.glsl"));
    assert_true(strlen(fault.text) > 0);
}

// A copy of the shaders in which one file has a mistake in its third line.
static void spoil_shaders(char folder[64]) {
    snprintf(folder, 64, "/tmp/balloon-shaders-XXXXXX");
    assert_non_null(mkdtemp(folder));
    char command[256];
    snprintf(command, sizeof command,
             "cp shaders/* %s && printf '\\n\\nnonsense\\n' >%s/floor.frag", folder, folder);
    assert_int_equal(system(command), 0);
}

static void a_broken_shader_is_named_with_its_line(void** state) {
    (void)state;
    char folder[64], location[128], command[128];
    spoil_shaders(folder);
    Fault fault = {0};
    const GLuint program = shader_load(folder, "floor.vert", "floor.frag", &fault);
    snprintf(command, sizeof command, "rm -r %s", folder);
    assert_int_equal(system(command), 0);

    assert_int_equal(program, 0);
    snprintf(location, sizeof location, "%s/floor.frag:", folder);
    assert_memory_equal(fault.location, location, strlen(location));
    const int line = atoi(fault.location + strlen(location));
    assert_in_range(line, 3, 4); // the compiler may see it only at the end
}

static void a_renderer_without_shaders_does_not_open(void** state) {
    (void)state;
    Renderer* renderer = NULL;
    Fault fault = {0};
    assert_false(renderer_open(&renderer, 16, 16, "no/such/folder", &fault));
    assert_null(renderer);
    assert_true(strlen(fault.text) > 0);
}

static int open_all(void** state) {
    (void)state;
    Fault fault = {0};
    if (egl_open_surfaceless(&egl, &fault))
        return 0;
    fault_print(&fault, stderr);
    return 1;
}

static int close_all(void** state) {
    (void)state;
    egl_close_surfaceless(&egl);
    return 0;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_shaders_compile),
        cmocka_unit_test(a_missing_shader_is_named),
        cmocka_unit_test(a_broken_shader_is_named_with_its_line),
        cmocka_unit_test(a_renderer_without_shaders_does_not_open),
    };
    return cmocka_run_group_tests(tests, open_all, close_all);
}
