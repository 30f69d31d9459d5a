/// The scene format as a table: one row for each key, with its name, unit, range, default and a
/// sentence, its type and its field in scene.h.
///
/// The reader stores values by these rows, refuses what does not fit, and lists them in its
/// sentences; the scene reference (assets/scenes/README.md) is printed from them.
#ifndef BALLOON_SCENE_KEY_H
#define BALLOON_SCENE_KEY_H

#include <stddef.h>

#include "base/parameter.h"
#include "scene/scene.h"

typedef enum KeyType {
    KEY_NUMBER,   ///< double
    KEY_OPTIONAL, ///< double*, NULL where the scene does not give it
    KEY_VECTOR,   ///< double*, three numbers
    KEY_NAME,     ///< an enum, by one of `names`
    KEY_FLAG,     ///< bool
    KEY_TEXT,     ///< char*, at most `longest` bytes
    KEY_TEXTS,    ///< char**, and their number
    KEY_MAPPING,  ///< a struct
    KEY_POINTER,  ///< a pointer to a struct, NULL where the scene does not give it
    KEY_LIST,     ///< a pointer to an array of structs, and their number
} KeyType;

typedef struct KeyGroup KeyGroup;
typedef struct Key Key;

struct Key {
    Parameter is;
    KeyType type;
    const char* old;         ///< earlier name, which is still read; NULL: none
    const char* of;          ///< row of the table that the group's `selector` names; NULL: of all
    size_t offset;           ///< of the field in the group's struct
    bool required;           ///< of each mapping that may hold it
    const char* absent;      ///< what holds without the key, where the row's default is no number
    size_t count_offset;     ///< of the field (unsigned) with a list's length
    unsigned shortest;       ///< fewest items of a list
    unsigned longest;        ///< [bytes] of a text
    const char* const* name; ///< [name_count]
    int name_count;
    const void* table; ///< [*table_count] pointers to rows, of which a text is a name
    const int* table_count;
    const KeyGroup* group;      ///< the keys of a mapping, or of each of a list's items
    const Parameter* parameter; ///< instead: [parameter_count] keys, doubles side by side
    int parameter_count;
};

/// The keys of one mapping, and the struct that they fill: rows of its own, then rows made from
/// another table (scene/keys/keys_table.c), or parameters.
struct KeyGroup {
    const Key* key; ///< [count]
    int count;
    bool (*more)(int index, Key* key); ///< false after the last; NULL: none
    const char* selector;              ///< the key that names a row of that table
    const Parameter* parameter;        ///< [parameter_count]
    int parameter_count;
    size_t size; ///< [bytes] of the struct
};

/// A row's numbers and words for keys that take any number, and for keys that take none.
#define ANY -INFINITY, INFINITY, false, false, false
#define POSITIVE 0, INFINITY, true, false, false
#define NOT_NEGATIVE 0, INFINITY, false, false, false
#define NO_NUMBER NULL, ANY, NAN

enum {
    WORD_LONGEST = 64,  ///< [bytes] of a name
    TEXT_LONGEST = 400, ///< [bytes] of a title or a model, so that paths fit their buffers
};

/// The keys of a whole scene, a WorldDef, and those of each of its balloons.
extern const KeyGroup scene_keys, balloon_keys;

/// Keys that other tables bring: a mapping for each force with parameters, in BalloonDef.force, and
/// the parameters of each material, in MembraneDef.parameter.
bool key_of_force(int index, Key* key);
bool key_of_material(int index, Key* key);

/// Row `index` of a group; false after the last.
bool key_at(const KeyGroup* group, int index, Key* key);

/// Whether a key is one of a mapping whose selector is `of`; NULL: any.
bool key_is_of(const Key* key, const char* of);

/// The row of a key; false where there is none.
bool key_find(const KeyGroup* group, const char* of, const char* name, Key* key);

/// The keys of a mapping, or of each of a list's items; without any for other types.
KeyGroup key_group(const Key* key);

/// "first, second, …", for sentences.
void key_names(const KeyGroup* group, const char* of, char* names, size_t size);

/// Whether a number lies in the range.
bool key_allows(const Parameter* range, double value);

/// "greater than 0 and at most 1", for a sentence; "any number" without a range.
void key_range(const Parameter* range, char words[96]);

/// Visit every key, a mapping before its keys. path: "balloons.*.scale", with * for an item's
/// number.
void key_each(void (*visit)(const char* path, const Key* key, void* context), void* context);

/// One value of a loaded scene.
typedef struct KeyValue {
    const char* path;    ///< "balloons.0.scale"
    const char* pattern; ///< "balloons.*.scale"
    const Key* key;
    bool present;  ///< not absent, empty, false, or the first of its names
    double number; ///< of KEY_NUMBER and KEY_OPTIONAL; NAN for other types
} KeyValue;

/// Visit every value that a scene has or has by default.
void key_each_value(const WorldDef* def, void (*visit)(const KeyValue* value, void* context),
                    void* context);

#endif
