#include "scene/reference.h"

#include <math.h>

#include "scene/key.h"

/// The names of a key that takes one of several: "`split`, `stop`, `off`".
static void print_names(FILE* out, const Key* key) {
    for (int i = 0; i < key->name_count; i++)
        fprintf(out, "%s`%s`", i ? ", " : "", key->name[i]);
}

/// The same of the rows of a table, which begin with their names.
static void print_rows(FILE* out, const Key* key) {
    const char* const* const* row = key->table;
    for (int i = 0; i < *key->table_count; i++)
        fprintf(out, "%s`%s`", i ? ", " : "", *row[i]);
}

static void print_value(FILE* out, const Key* key) {
    char range[96];
    key_range(&key->is, range);
    switch (key->type) {
        case KEY_NUMBER:
        case KEY_OPTIONAL:
            fputs(range, out);
            break;
        case KEY_VECTOR:
            fprintf(out, "3 numbers%s%s", key->is.min > -INFINITY ? ", each " : "",
                    key->is.min > -INFINITY ? range : "");
            break;
        case KEY_NAME:
            print_names(out, key);
            break;
        case KEY_FLAG:
            fputs("`true` or `false`", out);
            break;
        case KEY_TEXT:
            if (key->table)
                print_rows(out, key);
            else
                fprintf(out, "text, at most %u bytes", key->longest);
            break;
        case KEY_TEXTS:
            fprintf(out, "list of texts, each at most %u bytes", key->longest);
            break;
        case KEY_MAPPING:
        case KEY_POINTER:
            fputs("the keys below", out);
            break;
        case KEY_LIST:
            fprintf(out, "list%s, each item with the keys below",
                    key->shortest ? ", not empty" : "");
    }
}

/// What holds where the scene does not have the key.
static void print_default(FILE* out, const Key* key) {
    if (key->required)
        fputs("**required**", out);
    else if (key->absent)
        fputs(key->absent, out);
    else if (key->type == KEY_NAME)
        fprintf(out, "`%s`", key->name[0]);
    else if (key->type == KEY_FLAG)
        fputs("`false`", out);
    else if (isfinite(key->is.default_value))
        fprintf(out, "%.10g", key->is.default_value);
    else
        fputs("none", out);
}

static void print_row(const char* path, const Key* key, void* context) {
    FILE* out = context;
    fprintf(out, "| `%s` | %s | ", path, key->is.unit ? key->is.unit : "");
    print_value(out, key);
    fputs(" | ", out);
    print_default(out, key);
    fputs(" | ", out);
    if (key->of)
        fprintf(out, "`%s`: ", key->of);
    fprintf(out, "%s |\n", key->is.about);
}

void scene_reference(FILE* out) {
    fputs("### Keys\n\n"
          "`*` stands for the number of a list's item, from 0. Units are SI; with `units: paper`\n"
          "lengths, masses and forces are the mass-spring paper's own and have no SI unit.\n"
          "A required key must be in each mapping that may hold it.\n\n"
          "| path | unit | value | default | meaning |\n|---|---|---|---|---|\n",
          out);
    key_each(print_row, out);
}
