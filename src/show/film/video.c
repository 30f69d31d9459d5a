#include "show/film/video.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

// in the film, by which a later run knows it as its own
static const char comment_option[] = "comment=" VIDEO_MARK;

// players need 4:2:0 color, which is defined for even sizes only
static const char* const MP4[] = {"-c:v",      "libx264",      "-crf",      "18",
                                  "-pix_fmt",  "yuv420p",      "-movflags", "+faststart",
                                  "-metadata", comment_option, NULL};
static const char* const WEBM[] = {"-c:v",      "libvpx-vp9",   "-crf",    "30",      "-b:v",
                                   "0",         "-pix_fmt",     "yuv420p", "-row-mt", "1",
                                   "-metadata", comment_option, NULL};
// delays are hundredths of a second: 25 frames a second are exact, 60 are not. One palette for all
// frames
static const char* const GIF[] = {
    "-vf", "fps=25,split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=sierra2_4a", NULL};

const VideoFormat video_table[] = {{".mp4", "mp4", MP4, true, false},
                                   {".webm", "webm", WEBM, true, false},
                                   {".gif", "gif", GIF, false, true}};
const int video_count = sizeof video_table / sizeof *video_table;

enum { MAX_ARGUMENTS = 48 };

const VideoFormat* video_find(const char* file) {
    for (int k = 0; k < video_count; k++) {
        const size_t ending = strlen(video_table[k].ending), size = strlen(file);
        if (size > ending && strcmp(file + size - ending, video_table[k].ending) == 0)
            return &video_table[k];
    }
    return NULL;
}

/// Start ffmpeg with the pipe as its input; its messages go to a temporary file.
static bool spawn(Video* video, char* const* arguments, int input, Fault* fault) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, fileno(video->messages), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, fileno(video->messages), STDERR_FILENO);

    // in a group of its own: Ctrl-C is for us, who end or remove the film
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);

    pid_t process = 0;
    const int error = posix_spawnp(&process, "ffmpeg", &actions, &attributes, arguments, environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (error == ENOENT)
        return fault_set(fault, video->file,
                         "a video needs ffmpeg (apt-get install ffmpeg); a folder or a .png does "
                         "without");
    if (error)
        return fault_set(fault, video->file, "ffmpeg does not start: %s", strerror(error));
    video->process = process;
    return true;
}

static bool start(Video* video, const VideoFormat* format, int width, int height, double fps,
                  Fault* fault) {
    // without a shell; "file:" prevents that a name is read as an option or a URL
    char size[32], rate[32], target[1040];
    snprintf(size, sizeof size, "%dx%d", width, height);
    snprintf(rate, sizeof rate, "%.10g", fps);
    snprintf(target, sizeof target, "file:%s", video->temporary);
    const char* const before[] = {"ffmpeg",   "-loglevel", "error",  "-nostdin", "-y", "-f",
                                  "rawvideo", "-pix_fmt",  "rgb24",  "-s",       size, "-r",
                                  rate,       "-i",        "pipe:0", "-an",      NULL};
    const char* const after[] = {"-f", format->muxer, target, NULL};
    const char* const* const parts[] = {before, format->arguments, after};
    char* arguments[MAX_ARGUMENTS];
    int count = 0;
    for (int part = 0; part < 3; part++)
        for (int k = 0; parts[part][k]; k++)
            arguments[count++] = (char*)parts[part][k];
    arguments[count] = NULL;

    int ends[2];
    video->messages = tmpfile();
    if (!video->messages || pipe(ends) != 0)
        return fault_set(fault, video->file, "no pipe to ffmpeg: %s", strerror(errno));

    // ffmpeg must not inherit the writing end of its pipe, or it would never see it closed
    fcntl(ends[1], F_SETFD, FD_CLOEXEC);
    const bool good = spawn(video, arguments, ends[0], fault);
    close(ends[0]);
    video->pipe = fdopen(ends[1], "wb");
    return good;
}

bool video_open(Video* video, const VideoFormat* format, const char* file, int width, int height,
                double fps, Fault* fault) {
    *video = (Video){.frame = (size_t)width * (size_t)height * 3};
    video->add_comment = format->add_comment;
    snprintf(video->file, sizeof video->file, "%s", file);
    snprintf(video->temporary, sizeof video->temporary, "%s.part", file);
    FILE* probe = fopen(video->temporary, "wb");
    if (!probe)
        return fault_set(fault, file, "cannot be written: %s", strerror(errno));
    fclose(probe);

    // if ffmpeg ends early, writing must return an error rather than raise a signal
    signal(SIGPIPE, SIG_IGN);
    if (start(video, format, width, height, fps, fault))
        return true;
    video_close(video, false, fault);
    return false;
}

bool video_add(Video* video, const unsigned char* rgb, Fault* fault) {
    if (fwrite(rgb, 1, video->frame, video->pipe) == video->frame)
        return true;
    return video_close(video, false, fault);
}

/// The first line of ffmpeg's messages.
static void first_line(FILE* messages, char* line, int size) {
    rewind(messages);
    if (!fgets(line, size, messages))
        snprintf(line, (size_t)size, "it does not say why");
    line[strcspn(line, "\n")] = 0;
}

/// ffmpeg writes no comment into a GIF: a comment extension before the trailer, one byte.
static bool add_gif_comment(const char* file) {
    static const char comment[] = "\x21\xfe\x0f" VIDEO_MARK "\0\x3b"; // 15 bytes of text
    FILE* film = fopen(file, "r+b");
    if (!film)
        return false;
    const bool good = fseek(film, -1, SEEK_END) == 0 &&
                      fwrite(comment, 1, sizeof comment - 1, film) == sizeof comment - 1;
    return fclose(film) == 0 && good;
}

bool video_close(Video* video, bool complete, Fault* fault) {
    if (!video->file[0])
        return complete; // closed before
    if (video->pipe)
        complete = fclose(video->pipe) == 0 && complete;

    int status = 0;
    if (video->process && waitpid((pid_t)video->process, &status, 0) > 0 &&
        !(WIFEXITED(status) && WEXITSTATUS(status) == 0)) {
        char line[512];
        first_line(video->messages, line, sizeof line);
        complete = fault_set(fault, video->file, "ffmpeg failed: %s", line);
    }
    if (complete && video->add_comment && !add_gif_comment(video->temporary))
        complete = fault_set(fault, video->file, "cannot be written: %s", strerror(errno));
    if (complete && rename(video->temporary, video->file) != 0)
        complete = fault_set(fault, video->file, "cannot be written: %s", strerror(errno));
    if (!complete) {
        fault_set(fault, video->file, "the video could not be finished");
        remove(video->temporary);
    }
    if (video->messages)
        fclose(video->messages);
    *video = (Video){0};
    return complete;
}
