/// The scene format as a table: one row for each key, with its name, unit, range, default and a
/// sentence, its type and its field in scene.h.
///
/// The reader stores values by these rows, refuses what does not fit, and lists them in its
/// sentences; the scene reference (assets/scenes/README.md) is printed from them.
#ifndef BALLOON_SCENE_KEY_H
#define BALLOON_SCENE_KEY_H

#include <stddef.h>

#include "base/parameter.h"

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

typedef struct Key {
    Parameter is; ///< first, so that its name is the row's (base/table.h)
    KeyType type;
    size_t offset;           ///< of the field in the group's struct
    bool required;           ///< of each mapping that may hold it
    const char* absent;      ///< what holds without the key, where the row's default is no number
    size_t count_offset;     ///< of the field (unsigned) with a list's length
    unsigned shortest;       ///< fewest items of a list
    unsigned longest;        ///< [bytes] of a text
    const char* const* name; ///< [name_count]
    int name_count;
    const KeyGroup* group; ///< the keys of a mapping, or of each of a list's items
} Key;

/// The keys of one mapping, and the struct that they fill.
struct KeyGroup {
    const Key* key; ///< [count]
    int count;
    size_t size; ///< [bytes] of the struct
};

/// A row's numbers and words for keys that take any number, and for keys that take none.
#define ANY -INFINITY, INFINITY, false, false
#define POSITIVE 0, INFINITY, true, false
#define NOT_NEGATIVE 0, INFINITY, false, false
#define NO_NUMBER NULL, ANY, NAN

enum {
    WORD_LONGEST = 64,  ///< [bytes] of a name
    TEXT_LONGEST = 400, ///< [bytes] of a title or a model, so that paths fit their buffers
};

/// The keys of a whole scene, a WorldDef, and those of each of its balloons.
extern const KeyGroup scene_keys, balloon_keys;

/// The row of a key, or NULL.
const Key* key_find(const KeyGroup* group, const char* name);

/// "first, second, …", for sentences.
void key_names(const KeyGroup* group, char* names, size_t size);

/// Whether a number lies in the range.
bool key_allows(const Parameter* range, double value);

/// "greater than 0 and at most 1", for a sentence; "any number" without a range.
void key_range(const Parameter* range, char words[96]);

/// Visit every key, a mapping before its keys. path: "balloons.*.scale", with * for an item's
/// number.
void key_each(void (*visit)(const char* path, const Key* key, void* context), void* context);

#endif
