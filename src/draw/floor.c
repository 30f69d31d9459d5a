#include "draw/floor.h"

#include "draw/shader.h"

bool floor_open(Floor* floor, const char* shader_dir, Fault* fault) {
    floor->floor = shader_load(shader_dir, "floor.vert", "floor.frag", fault);
    floor->backdrop = shader_load(shader_dir, "screen.vert", "backdrop.frag", fault);
    floor->shadow = shadow_open();
    glGenVertexArrays(1, &floor->empty);

    glGenTextures(1, &floor->texture);
    glBindTexture(GL_TEXTURE_2D, floor->texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, SHADOW_SIDE, SHADOW_SIDE, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return floor->floor && floor->backdrop;
}

void floor_upload(Floor* floor, const Picture* picture) {
    if (!picture->floor || (picture->stamp != 0 && picture->stamp == floor->stamp))
        return;
    floor->stamp = picture->stamp;
    shadow_cast(&floor->shadow, picture);
    glBindTexture(GL_TEXTURE_2D, floor->texture);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, SHADOW_SIDE, SHADOW_SIDE, GL_RGBA, GL_UNSIGNED_BYTE,
                    floor->shadow.light);
}

void floor_draw(const Floor* floor, const Picture* picture) {
    glBindVertexArray(floor->empty);
    glBindTexture(GL_TEXTURE_2D, floor->texture);
    if (picture->floor) {
        glUseProgram(floor->floor);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }

    // the backdrop lies on the far plane, behind everything
    glUseProgram(floor->backdrop);
    glDepthMask(GL_FALSE);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthMask(GL_TRUE);
}

void floor_close(Floor* floor) {
    shadow_close(&floor->shadow);
    glDeleteTextures(1, &floor->texture);
    glDeleteVertexArrays(1, &floor->empty);
    glDeleteProgram(floor->floor);
    glDeleteProgram(floor->backdrop);
}
