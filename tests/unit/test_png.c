/// PNG files and videos are read back as written; after a fault no file remains.
#include "law.h"

#include <dirent.h>
#include <sys/stat.h>
#include <unistd.h>

#include <png.h>

#include "base/memory.h"
#include "show/film/png.h"
#include "show/film/video.h"

enum { WIDTH = 37, HEIGHT = 23 };

static char folder[32];

static int open_folder(void** state) {
    (void)state;
    snprintf(folder, sizeof folder, "/tmp/balloon-XXXXXX");
    return mkdtemp(folder) ? 0 : -1;
}

static int close_folder(void** state) {
    (void)state;
    return rmdir(folder);
}

static void in_folder(const char* name, char file[64]) {
    snprintf(file, 64, "%s/%s", folder, name);
}

static void fill(unsigned char* rgb, int seed) {
    for (int i = 0; i < 3 * WIDTH * HEIGHT; i++)
        rgb[i] = (unsigned char)(i * i / 7 + seed * i);
}

static void a_picture_is_read_back_to_the_last_bit(void** state) {
    (void)state;
    unsigned char wrote[3 * WIDTH * HEIGHT], got[3 * WIDTH * HEIGHT];
    char file[64];
    Fault fault = {0};
    in_folder("a.png", file);
    fill(wrote, 1);
    assert_true(png_write_rgb(file, wrote, WIDTH, HEIGHT, &fault));

    png_image image = {.version = PNG_IMAGE_VERSION};
    assert_int_equal(png_image_begin_read_from_file(&image, file), 1);
    assert_int_equal(image.width, WIDTH);
    assert_int_equal(image.height, HEIGHT);
    image.format = PNG_FORMAT_RGB;
    assert_int_equal(png_image_finish_read(&image, NULL, got, 0, NULL), 1);
    assert_memory_equal(got, wrote, sizeof got);
    unlink(file);
}

static void a_picture_that_cannot_be_written_is_a_fault(void** state) {
    (void)state;
    unsigned char rgb[3 * WIDTH * HEIGHT] = {0};
    char file[64];
    Fault fault = {0};
    in_folder("none/a.png", file);
    assert_false(png_write_rgb(file, rgb, WIDTH, HEIGHT, &fault));
    assert_string_equal(fault.location, file);
    assert_true(fault.text[0] != 0);
}

static bool exists(const char* file) {
    struct stat about;
    return stat(file, &about) == 0 && about.st_size > 0;
}

static void every_format_makes_a_video(void** state) {
    (void)state;
    for (int k = 0; k < video_count; k++) {
        unsigned char rgb[3 * WIDTH * HEIGHT];
        char name[32], file[64];
        Video video;
        Fault fault = {0};
        // a name with a meaning to a shell or an option parser
        snprintf(name, sizeof name, "-y $(id) '%s", video_table[k].ending);
        in_folder(name, file);
        assert_ptr_equal(video_find(file), &video_table[k]);
        const int odd = !video_table[k].even;
        bool good = video_open(&video, &video_table[k], file, WIDTH / 2 * 2 + odd,
                               HEIGHT / 2 * 2 + odd, 30, &fault);
        for (int n = 0; good && n < 8; n++) {
            fill(rgb, n);
            good = video_add(&video, rgb, &fault);
        }
        good = good && video_close(&video, true, &fault);
        if (!good)
            fail_msg("%s: %s", fault.location, fault.text);
        assert_true(exists(file));
        unlink(file);
    }
}

static int count_files(void) {
    int count = 0;
    DIR* entries = opendir(folder);
    for (const struct dirent* entry; (entry = readdir(entries));)
        count += entry->d_name[0] != '.';
    closedir(entries);
    return count;
}

static void a_video_that_is_given_up_leaves_nothing(void** state) {
    (void)state;
    unsigned char rgb[3 * WIDTH * HEIGHT] = {0};
    char file[64];
    Video video;
    Fault fault = {0};
    in_folder("a.mp4", file);
    assert_true(video_open(&video, video_find(file), file, WIDTH, HEIGHT, 30, &fault));
    assert_true(video_add(&video, rgb, &fault));
    assert_false(video_close(&video, false, &fault));
    assert_int_equal(count_files(), 0);
}

static void without_ffmpeg_a_sentence_says_so(void** state) {
    (void)state;
    char file[64], path[4096];
    snprintf(path, sizeof path, "%s", getenv("PATH"));
    Video video;
    Fault fault = {0};
    in_folder("a.mp4", file);
    setenv("PATH", folder, 1);
    const bool good = video_open(&video, video_find(file), file, WIDTH, HEIGHT, 30, &fault);
    setenv("PATH", path, 1);
    assert_false(good);
    assert_non_null(strstr(fault.text, "needs ffmpeg"));
    assert_int_equal(count_files(), 0);
}

static void only_known_endings_are_videos(void** state) {
    (void)state;
    assert_null(video_find("out"));
    assert_null(video_find("out.avi"));
    assert_null(video_find("mp4"));
    assert_null(video_find(".mp4"));
    assert_non_null(video_find("a.b.mp4"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_picture_is_read_back_to_the_last_bit),
        cmocka_unit_test(a_picture_that_cannot_be_written_is_a_fault),
        cmocka_unit_test(every_format_makes_a_video),
        cmocka_unit_test(a_video_that_is_given_up_leaves_nothing),
        cmocka_unit_test(without_ffmpeg_a_sentence_says_so),
        cmocka_unit_test(only_known_endings_are_videos),
    };
    return cmocka_run_group_tests(tests, open_folder, close_folder);
}
