#include "show/output.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/memory.h"
#include "draw/egl.h"
#include "show/pacer.h"
#include "show/film/png.h"
#include "show/film/video.h"

/// A destination of frames: a folder, a still, a film, or none.
typedef struct Frames Frames;
typedef struct Writer {
    bool (*open)(Frames* frames, Fault* fault);
    bool (*add)(Frames* frames, Fault* fault);
    bool (*close)(Frames* frames, bool complete, Fault* fault);
} Writer;

struct Frames {
    FramesDef def;
    Egl egl;
    const Writer* writer;
    Video video;
    unsigned char* rgb; ///< [height * width * 3]
    long count;         ///< number of frames
    long done;          ///< frames written
};

// ---- a folder of PNG files ----

static void frame_name(const Frames* frames, long number, char file[1024]) {
    snprintf(file, 1024, "%s/frame-%05ld.png", frames->def.out, number);
}

/// Whether a file can be written, by a trial.
static bool try_file(const char* file, const char* out, Fault* fault) {
    char temporary[1100];
    snprintf(temporary, sizeof temporary, "%s.part", file);
    FILE* trial = fopen(temporary, "wb");
    if (!trial)
        return fault_set(fault, out, "cannot be written: %s", strerror(errno));
    fclose(trial);
    remove(temporary);
    return true;
}

static bool folder_open(Frames* frames, Fault* fault) {
    if (mkdir(frames->def.out, 0777) != 0 && errno != EEXIST)
        return fault_set(fault, frames->def.out, "this folder cannot be made: %s", strerror(errno));
    char file[1024];
    frame_name(frames, 0, file);
    return try_file(file, frames->def.out, fault);
}

static bool folder_add(Frames* frames, Fault* fault) {
    char file[1024];
    frame_name(frames, frames->done, file);
    return png_write_rgb(file, frames->rgb, frames->def.width, frames->def.height, fault);
}

static void print_count(const Frames* frames, bool complete) {
    if (complete && !frames->def.quiet)
        printf("%ld frame%s in %s\n", frames->done, frames->done == 1 ? "" : "s", frames->def.out);
}

static bool folder_close(Frames* frames, bool complete, Fault* fault) {
    (void)fault;
    print_count(frames, complete);
    return complete;
}

// ---- one PNG file of the final state ----

static bool still_open(Frames* frames, Fault* fault) {
    return try_file(frames->def.out, frames->def.out, fault);
}

static bool still_add(Frames* frames, Fault* fault) {
    return png_write_rgb(frames->def.out, frames->rgb, frames->def.width, frames->def.height,
                         fault);
}

static bool still_close(Frames* frames, bool complete, Fault* fault) {
    (void)fault;
    if (complete && !frames->def.quiet)
        printf("%s\n", frames->def.out);
    return complete;
}

// ---- a video ----

static bool film_open(Frames* frames, Fault* fault) {
    const FramesDef* def = &frames->def;
    return video_open(&frames->video, video_find(def->out), def->out, def->width, def->height,
                      def->fps, fault);
}

static bool film_add(Frames* frames, Fault* fault) {
    return video_add(&frames->video, frames->rgb, fault);
}

static bool film_close(Frames* frames, bool complete, Fault* fault) {
    complete = video_close(&frames->video, complete, fault);
    print_count(frames, complete);
    return complete;
}

// ---- nothing ----

static bool nothing(Frames* frames, Fault* fault) {
    (void)frames;
    (void)fault;
    return true;
}

static bool nothing_close(Frames* frames, bool complete, Fault* fault) {
    (void)frames;
    (void)fault;
    return complete;
}

static const Writer folder = {folder_open, folder_add, folder_close};
static const Writer still = {still_open, still_add, still_close};
static const Writer film = {film_open, film_add, film_close};

static const Writer none = {nothing, nothing, nothing_close};

/// An ending that neither a picture nor a film has, unless there is a folder of that name.
static bool is_other_format(const char* out, const Writer* writer) {
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
    const char *dot = strrchr(out, '.'), *slash = strrchr(out, '/');
    struct stat found;
    return writer == &folder && dot && dot > out && (!slash || dot > slash + 1) && dot[1] &&
           dot[1 + strspn(dot + 1, letters)] == 0 && strlen(dot + 1) <= 4 && stat(out, &found) != 0;
}

/// Whether pictures of this size can be written there.
static bool format_is_right(const Writer* writer, const FramesDef* def, Fault* fault) {
    if (def->out && is_other_format(def->out, writer))
        return fault_set(fault, def->out,
                         "not a format of pictures or films: .png, .mp4, .webm, .gif; a folder of "
                         "this name must be there first");
    if (writer == &film && video_find(def->out)->even && (def->width % 2 || def->height % 2))
        return fault_set(fault, "--size", "a film as %s has even sides, not %dx%d",
                         video_find(def->out)->ending, def->width, def->height);
    return true;
}

static const Writer* writer_for(const char* out) {
    if (!out)
        return &none;
    const char* dot = strrchr(out, '.');
    if (dot && strcmp(dot, ".png") == 0)
        return &still;
    return video_find(out) ? &film : &folder;
}

// ---- the output ----

static bool next(void* self, Input* input) {
    const Frames* frames = self;
    const FramesDef* def = &frames->def;
    if (frames->done == frames->count)
        return false;

    // frame k is at time k/fps; a still is at the end
    double elapsed = frames->done == 0 ? 0 : 1 / def->fps;
    if (frames->writer == &still)
        elapsed = def->seconds;
    *input = (Input){.elapsed = elapsed,
                     .width = def->width,
                     .height = def->height,
                     .scale = fmaxf(1, (float)def->height / 720)};
    return true;
}

static bool never_late(void* self) {
    (void)self;
    return false;
}

static bool present(void* self, const Renderer* renderer, Fault* fault) {
    Frames* frames = self;
    renderer_read(renderer, frames->rgb);
    if (!frames->writer->add(frames, fault))
        return false;
    frames->done++;
    if (!frames->def.quiet && isatty(STDERR_FILENO))
        fprintf(stderr, "\rframe %ld/%ld%s", frames->done, frames->count,
                frames->done == frames->count ? "\n" : "");
    return true;
}

static bool close_frames(void* self, bool complete, Fault* fault) {
    Frames* frames = self;
    complete = frames->writer->close(frames, complete, fault);
    egl_close_surfaceless(&frames->egl);
    free(frames->rgb);
    free(frames);
    return complete;
}

bool output_frames(Output* output, const FramesDef* def, Fault* fault) {
    Frames* frames = new_array(Frames, 1);
    frames->def = *def;
    frames->writer = writer_for(def->out);
    frames->rgb = new_array(unsigned char, (size_t)def->width*(size_t)def->height * 3);
    frames->count = frames->writer == &still ? 1 : 1 + pacer_steps(def->seconds, 1 / def->fps);
    *output = (Output){.self = frames,
                       .next = next,
                       .late = never_late,
                       .present = present,
                       .close = close_frames};

    // EGL first: a machine that cannot draw must leave no folder behind
    if (format_is_right(frames->writer, def, fault) && egl_open_surfaceless(&frames->egl, fault) &&
        frames->writer->open(frames, fault))
        return true;
    egl_close_surfaceless(&frames->egl);
    free(frames->rgb);
    free(frames);
    return false;
}
