#include "mesh/obj.h"

#include <locale.h>
#include <stdarg.h>
#include <string.h>

#include "base/memory.h"
#include "mesh/file.h"
#include "mesh/lines.h"

enum {
    DIGITS_MOST = 9,   ///< an index of more digits is out of range of any file, and of an int
    PLAIN_V_BYTES = 24 ///< [bytes] a plain `v` line needs at most 15
};

typedef struct Reader {
    Lines lines;
    char* out;          ///< where the plain text goes on
    MeshSource* source; ///< filled up to its counts
    Fault* fault;
} Reader;

/// One sentence about the line at hand.
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

/// "v NUMBER 0 0"; printf would take as long as reading the coordinates.
static void write_plain_v(Reader* reader, int number) {
    char digit[PLAIN_V_BYTES];
    int count = 0;
    do
        digit[count++] = (char)('0' + number % 10);
    while ((number /= 10) > 0);

    *reader->out++ = 'v';
    *reader->out++ = ' ';
    while (count > 0)
        *reader->out++ = digit[--count];
    memcpy(reader->out, " 0 0\n", 5);
    reader->out += 5;
}

/// v x y z, and after them a weight or a colour, which must be numbers but do not matter.
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
    source->point_line[source->point_count] = reader->lines.number;
    write_plain_v(reader, source->point_count++);
    return true;
}

/// One corner, "7", "-1", "7/2", "7//3" or "7/2/3": its first number goes on if it can be an index.
static bool copy_corner(Reader* reader) {
    char* word = reader->lines.at;
    char* at = word;
    *reader->out++ = ' ';
    if (*at == '-')
        *reader->out++ = *at++;
    else if (*at == '+')
        at++;
    const char* sign_end = at;
    while (*at == '0')
        at++;
    const char* digits = at;
    while (*at >= '0' && *at <= '9') {
        if (at - digits < DIGITS_MOST + 1)
            *reader->out++ = *at;
        at++;
    }
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
    if (count > DIGITS_MOST)
        return refuse(reader, "there is no vertex %.*s", word_shown(word), word);
    return true;
}

static bool read_face(Reader* reader) {
    MeshSource* source = reader->source;
    int corners = 0;
    *reader->out++ = 'f';
    for (; lines_word(&reader->lines); corners++)
        if (!copy_corner(reader))
            return false;
    *reader->out++ = '\n';
    if (corners < 3 || corners > 4)
        return refuse(reader,
                      "face %d has %d corner%s; only quads and triangles can be balloons: %s",
                      source->face_count + 1, corners, corners == 1 ? "" : "s",
                      corners > 4 ? "split it" : "delete it");
    source->face_line[source->face_count++] = reader->lines.number;
    return true;
}

/// Whether the line begins with this one-letter word; then reading stands behind it.
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

/// At most so many vertices and faces, so that arrays are made once.
static void count_lines(const FileText* file, int* points, int* faces) {
    const char* end = file->text + file->size;
    for (const char* at = file->text; at && at < end;) {
        while (is_blank(*at))
            at++;
        *points += is_line_of(at, 'v');
        *faces += is_line_of(at, 'f');
        at = memchr(at, '\n', (size_t)(end - at));
        at += at != NULL;
    }
}

static bool read_lines(ObjText* obj, MeshSource* source, const FileText* file, Fault* fault) {
    Reader reader = {
        .lines = {.next = file->text, .end = file->text + file->size},
        .out = obj->text,
        .source = source,
        .fault = fault,
    };
    while (lines_take(&reader.lines))
        if (!read_line(&reader))
            return false;
    obj->size = (size_t)(reader.out - obj->text);
    if (source->point_count == 0)
        return fault_set(fault, source->name, "has no vertices ('v' lines); is it an OBJ file?");
    if (source->face_count == 0)
        return fault_set(fault, source->name,
                         "has no faces ('f' lines), and a skin is made of faces");
    return true;
}

/// Room for all that the file can hold, with the counts at zero.
static bool make_room(ObjText* obj, MeshSource* source, const char* path, const FileText* file,
                      Fault* fault) {
    int points = 0;
    int faces = 0;
    count_lines(file, &points, &faces);
    if (points > POINTS_MOST || faces > FACES_MOST)
        return fault_set(fault, path, "has %d vertices and %d faces; at most %d and %d can be read",
                         points, faces, POINTS_MOST, FACES_MOST);
    source_make(source, path, points, faces);
    source->point_line = new_array(long, points);
    source->face_line = new_array(long, faces);
    source->point_count = 0;
    source->face_count = 0;
    obj->text = new_array(char, file->size + PLAIN_V_BYTES * ((size_t)points + 1));
    return true;
}

bool obj_read(ObjText* obj, MeshSource* source, const char* path, Fault* fault) {
    *obj = (ObjText){0};
    *source = (MeshSource){0};
    FileText file;
    if (!file_read(&file, path, FILE_BYTES_MOST, fault))
        return false;

    // a decimal point is a point, whatever the user's language
    const locale_t c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    const locale_t users = uselocale(c_locale);
    const bool good =
        make_room(obj, source, path, &file, fault) && read_lines(obj, source, &file, fault);
    uselocale(users);
    freelocale(c_locale);

    file_free(&file);
    if (!good) {
        obj_free(obj);
        source_free(source);
    }
    return good;
}

bool obj_check_corners(const ObjText* obj, const MeshSource* source, Fault* fault) {
    const char* end = obj->text + obj->size;
    int points = 0;
    int face = 0;
    for (char* at = obj->text; at < end; at = strchr(at, '\n') + 1) {
        points += *at == 'v';
        if (*at != 'f')
            continue;
        for (at++; *at == ' ';) {
            const long index = strtol(at, &at, 10);
            const long point = index < 0 ? points + index : index - 1;
            if (point < 0 || point >= source->point_count)
                return fault_at(fault, source->name, source->face_line[face],
                                "face %d names vertex %ld, but there are only %d%s", face + 1,
                                index, index < 0 ? points : source->point_count,
                                index < 0 ? " above it" : "");
        }
        face++;
    }
    return true;
}

void obj_free(ObjText* obj) {
    free(obj->text);
    *obj = (ObjText){0};
}
