#include "mesh/obj.h"

#include <locale.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "mesh/file.h"
#include "mesh/lines.h"
#include "mesh/mesh.h"

enum { DIGITS_MAX = 9 }; ///< an index of more digits is out of range of any file, and of an int

typedef struct Reader {
    Lines lines;
    MeshSource* source; ///< filled up to its counts
    Fault* fault;
} Reader;

/// A fault at the current line.
__attribute__((format(printf, 2, 3))) static bool refuse(const Reader* reader, const char* format,
                                                         ...) {
    char text[256];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return fault_at(reader->fault, reader->source->name, reader->lines.number, "%s", text);
}

static bool read_number(Reader* reader, double* number) {
    Lines* lines = &reader->lines;
    char* stop;
    *number = strtod(lines->at, &stop);
    if (stop == lines->at || !ends_word(*stop))
        return refuse(reader, "'%.*s' is not a number", word_shown(lines->at), lines->at);
    if (!isfinite(*number))
        return refuse(reader, "'%.*s' is not a finite number; a vertex needs a place",
                      word_shown(lines->at), lines->at);
    lines->at = stop;
    return true;
}

/// v x y z, and after them a weight or a color, which must be numbers and are ignored.
static bool read_point(Reader* reader) {
    MeshSource* source = reader->source;
    double4 point = {0};
    int numbers = 0;
    for (; lines_word(&reader->lines); numbers++) {
        double number;
        if (!read_number(reader, &number))
            return false;
        if (numbers < 3)
            point[numbers] = number;
    }
    if (numbers < 3)
        return refuse(reader, "a vertex needs three coordinates, here are %d", numbers);
    source->point[source->point_count] = point;
    source->point_line[source->point_count++] = reader->lines.number;
    return true;
}

/// The vertex, from 0, that an index of the current face names; NONE and a fault if there is none.
/// A positive index may name a vertex further down: check_corners looks at it.
static int find_point(const Reader* reader, bool backward, int index) {
    const MeshSource* source = reader->source;
    if (!backward)
        return index - 1;
    if (index <= source->point_count)
        return source->point_count - index;
    refuse(reader, "face %d names vertex %d, but there are only %d above it",
           source->face_count + 1, -index, source->point_count);
    return NONE;
}

/// One corner, "7", "-1", "7/2", "7//3" or "7/2/3": its first number is the vertex.
static bool read_corner(Reader* reader, int* point) {
    char* word = reader->lines.at;
    char* at = word;
    const bool backward = *at == '-';
    if (*at == '-' || *at == '+')
        at++;
    const char* sign_end = at;
    while (*at == '0')
        at++;
    const char* digits = at;
    int index = 0;
    for (; *at >= '0' && *at <= '9'; at++)
        if (at - digits < DIGITS_MAX)
            index = 10 * index + (*at - '0');
    const long count = at - digits;
    const bool number = at > sign_end && (ends_word(*at) || *at == '/');
    while (*at == '/' || *at == '-' || *at == '+' || (*at >= '0' && *at <= '9'))
        at++;
    reader->lines.at = at;
    if (!number || !ends_word(*at))
        return refuse(reader, "'%.*s' is not a corner of a face; write its vertex's number",
                      word_shown(word), word);
    if (count == 0)
        return refuse(reader, "a corner names vertex 0; they count from 1, or back from -1");
    if (count > DIGITS_MAX)
        return refuse(reader, "there is no vertex %.*s", word_shown(word), word);
    *point = find_point(reader, backward, index);
    return *point != NONE;
}

static bool read_face(Reader* reader) {
    MeshSource* source = reader->source;
    int* face = source->face[source->face_count];
    face[3] = NONE;
    int corners = 0;
    for (; lines_word(&reader->lines); corners++) {
        int point = NONE;
        if (!read_corner(reader, &point))
            return false;
        if (corners < 4)
            face[corners] = point;
    }
    if (corners < 3 || corners > 4)
        return refuse(reader,
                      "face %d has %d corner%s; only quads and triangles can be balloons: %s",
                      source->face_count + 1, corners, corners == 1 ? "" : "s",
                      corners > 4 ? "split it" : "delete it");
    source->face_line[source->face_count++] = reader->lines.number;
    return true;
}

/// Whether the line begins with this one-letter word; if so, reading continues after it.
static bool begins(Lines* lines, char word) {
    if (lines->at[0] != word || !ends_word(lines->at[1]))
        return false;
    lines->at++;
    return true;
}

static bool read_line(Reader* reader) {
    Lines* lines = &reader->lines;
    const bool point = begins(lines, 'v');
    if (point || begins(lines, 'f')) {
        lines_complete(lines);
        return point ? read_point(reader) : read_face(reader);
    }
    const bool loose = begins(lines, 'p');
    if (loose || begins(lines, 'l'))
        return refuse(reader,
                      "'%c' draws loose %s; only quads and triangles can be balloons: delete it",
                      loose ? 'p' : 'l', loose ? "points" : "lines");
    return true;
}

static bool is_line_of(const char* at, char word) {
    return at[0] == word && (ends_word(at[1]) || at[1] == '\n');
}

/// Upper bounds of the numbers of vertices and faces, so that arrays are made once.
static void count_lines(const FileText* file, int* points, int* faces) {
    const char* end = file->text + file->size;
    const char* at = file->text;
    while (at < end) {
        while (is_blank(*at))
            at++;
        *points += is_line_of(at, 'v');
        *faces += is_line_of(at, 'f');
        const char* newline = memchr(at, '\n', (size_t)(end - at));
        at = newline ? newline + 1 : end;
    }
}

/// Every corner names a vertex of the file.
static bool check_corners(const MeshSource* source, Fault* fault) {
    for (int f = 0; f < source->face_count; f++)
        for (int k = 0; k < 4; k++)
            if (source->face[f][k] >= source->point_count)
                return fault_at(fault, source->name, source->face_line[f],
                                "face %d names vertex %d, but there are only %d", f + 1,
                                source->face[f][k] + 1, source->point_count);
    return true;
}

static bool read_lines(MeshSource* source, const FileText* file, Fault* fault) {
    Reader reader = {
        .lines = {.next = file->text, .end = file->text + file->size},
        .source = source,
        .fault = fault,
    };
    while (lines_next(&reader.lines))
        if (!read_line(&reader))
            return false;
    if (source->point_count == 0)
        return fault_set(fault, source->name, "has no vertices ('v' lines); is it an OBJ file?");
    if (source->face_count == 0)
        return fault_set(fault, source->name,
                         "has no faces ('f' lines), and a skin is made of faces");
    return check_corners(source, fault);
}

/// Allocate arrays with the bounds as capacities, and set the counts to zero.
static bool make_arrays(MeshSource* source, const char* path, const FileText* file, Fault* fault) {
    int points = 0;
    int faces = 0;
    count_lines(file, &points, &faces);
    if (!source_make_bounded(source, path, points, faces, fault))
        return false;
    source->point_line = new_array(long, points);
    source->face_line = new_array(long, faces);
    source->point_count = 0;
    source->face_count = 0;
    return true;
}

bool obj_read(MeshSource* source, const char* path, Fault* fault) {
    *source = (MeshSource){0};
    FileText file;
    if (!file_read(&file, path, FILE_BYTES_MAX, fault))
        return false;

    // a decimal point is a point, whatever the user's language
    const locale_t c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    const locale_t users = uselocale(c_locale);
    const bool good = make_arrays(source, path, &file, fault) && read_lines(source, &file, fault);
    uselocale(users);
    freelocale(c_locale);

    file_free(&file);
    if (!good)
        source_free(source);
    return good;
}
