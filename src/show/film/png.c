#include "show/film/png.h"

#include <errno.h>
#include <setjmp.h>
#include <string.h>

#include <png.h>

#include "show/film/video.h"

// Level 1 with one filter takes a fifth of the time of libpng's defaults; files are little larger.
enum { COMPRESSION = 1 };

/// libpng reports errors by longjmp, so this function has no local variables that change.
static bool encode(png_struct* png, png_info* info, FILE* out, const unsigned char* rgb, int width,
                   int height) {
    const png_text comment = {.compression = PNG_TEXT_COMPRESSION_NONE,
                              .key = (char*)"Software",
                              .text = (char*)VIDEO_MARK};
    if (setjmp(png_jmpbuf(png)))
        return false;
    png_init_io(png, out);
    png_set_compression_level(png, COMPRESSION);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    png_set_IHDR(png, info, (png_uint_32)width, (png_uint_32)height, 8, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_text(png, info, &comment, 1);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, info);
    for (int y = 0; y < height; y++)
        png_write_row(png, rgb + (size_t)y * (size_t)width * 3);
    png_write_end(png, info);
    return true;
}

// png_write_rgb reports errors by its own fault.
static void on_error(png_struct* png, const char* text) {
    (void)text;
    png_longjmp(png, 1);
}

static void ignore_warning(png_struct* png, const char* text) {
    (void)png;
    (void)text;
}

static bool write_to(FILE* out, const unsigned char* rgb, int width, int height) {
    png_struct* png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, on_error, ignore_warning);
    png_info* info = png ? png_create_info_struct(png) : NULL;
    const bool good = info && encode(png, info, out, rgb, width, height);
    png_destroy_write_struct(&png, &info);
    return good;
}

bool png_write_rgb(const char* file, const unsigned char* rgb, int width, int height,
                   Fault* fault) {
    // a temporary name until the file is complete
    char temporary[1024];
    if (snprintf(temporary, sizeof temporary, "%s.part", file) >= (int)sizeof temporary)
        return fault_set(fault, file, "the name is too long");
    FILE* out = fopen(temporary, "wb");
    if (!out)
        return fault_set(fault, file, "cannot be written: %s", strerror(errno));

    bool good = write_to(out, rgb, width, height);
    good = fclose(out) == 0 && good;
    if (good && rename(temporary, file) == 0)
        return true;
    fault_set(fault, file, "cannot be written: %s", strerror(errno));
    remove(temporary);
    return false;
}
