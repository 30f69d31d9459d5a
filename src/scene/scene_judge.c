#include "scene/scene_judge.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "scene/scene_range.h"
#include "scene/scene_schema.h"

typedef struct Judge {
    const SceneTree* tree;
    Fault* fault;
    char path[256]; ///< of the value under judgement, "" for the scene itself
    int nodes;      ///< judged so far
} Judge;

static bool judge_value(Judge* judge, const cyaml_schema_value_t* schema, int node);

// The value's path as the subject of a sentence.
static const char* subject(const Judge* judge) {
    return judge->path[0] ? judge->path : "a scene";
}

// Judge a part of the value; the path is the whole's again afterwards.
static bool judge_part(Judge* judge, const char* part, const cyaml_schema_value_t* schema,
                       int node) {
    const size_t length = strlen(judge->path);
    snprintf(judge->path + length, sizeof judge->path - length, "%s%s", length ? "." : "", part);
    const bool good = judge_value(judge, schema, node);
    judge->path[length] = '\0';
    return good;
}

static void known_keys(const cyaml_schema_field_t* field, char* words, size_t size) {
    size_t length = 0;
    for (; field->key && length < size; field++)
        length +=
            (size_t)snprintf(words + length, size - length, "%s%s", length ? ", " : "", field->key);
}

static const cyaml_schema_field_t* field_of(const cyaml_schema_value_t* schema, const char* key) {
    const cyaml_schema_field_t* field = schema->mapping.fields;
    while (field->key && strcmp(field->key, key) != 0)
        field++;
    return field->key ? field : NULL;
}

static bool key_fault(Judge* judge, const cyaml_schema_value_t* schema, int node, const char* key) {
    char words[512];
    known_keys(schema->mapping.fields, words, sizeof words);
    return tree_fault(judge->tree, node, judge->fault, "no key '%.64s' in %s; there are %s", key,
                      subject(judge), words);
}

static bool judge_required(Judge* judge, const cyaml_schema_value_t* schema, int node) {
    for (const cyaml_schema_field_t* field = schema->mapping.fields; field->key; field++)
        if (!(field->value.flags & CYAML_FLAG_OPTIONAL) &&
            !tree_slot(judge->tree, node, field->key, strlen(field->key)))
            return tree_fault(judge->tree, node, judge->fault, "%s needs the key '%s'",
                              subject(judge), field->key);
    return true;
}

static bool judge_mapping(Judge* judge, const cyaml_schema_value_t* schema, int id) {
    const yaml_node_t* node = tree_node(judge->tree, id);
    if (node->type != YAML_MAPPING_NODE) {
        char words[512];
        known_keys(schema->mapping.fields, words, sizeof words);
        return tree_fault(judge->tree, id, judge->fault,
                          "%s must be keys with values; there are %s", subject(judge), words);
    }
    const yaml_node_pair_t* pair = node->data.mapping.pairs.start;
    for (; pair < node->data.mapping.pairs.top; pair++) {
        const yaml_node_t* key = tree_node(judge->tree, pair->key);
        if (key->type != YAML_SCALAR_NODE)
            return tree_fault(judge->tree, pair->key, judge->fault, "a key in %s must be a word",
                              subject(judge));
        const char* word = (const char*)key->data.scalar.value;
        const cyaml_schema_field_t* field = field_of(schema, word);
        if (!field || strlen(word) != key->data.scalar.length)
            return key_fault(judge, schema, pair->key, word);
        if (tree_slot(judge->tree, id, word, strlen(word)) != &pair->value)
            return tree_fault(judge->tree, pair->key, judge->fault, "'%s' stands twice in %s", word,
                              subject(judge));
        if (!judge_part(judge, word, &field->value, pair->value))
            return false;
    }
    return judge_required(judge, schema, id);
}

static bool judge_list(Judge* judge, const cyaml_schema_value_t* schema, int id) {
    const yaml_node_t* node = tree_node(judge->tree, id);
    const bool fixed = schema->type == CYAML_SEQUENCE_FIXED;
    const unsigned least = schema->sequence.min;
    if (node->type != YAML_SEQUENCE_NODE)
        return fixed
                   ? tree_fault(judge->tree, id, judge->fault,
                                "%s must be a list of %u numbers, as in [0, 1, 0]", subject(judge),
                                least)
                   : tree_fault(judge->tree, id, judge->fault, "%s must be a list", subject(judge));

    const long count = node->data.sequence.items.top - node->data.sequence.items.start;
    if (fixed && count != least)
        return tree_fault(judge->tree, id, judge->fault, "%s must be %u numbers, not %ld",
                          subject(judge), least, count);
    if (count < least)
        return tree_fault(judge->tree, id, judge->fault, "%s needs at least %u", subject(judge),
                          least);
    for (long i = 0; i < count; i++) {
        char item[24];
        snprintf(item, sizeof item, "%ld", i);
        if (!judge_part(judge, item, schema->sequence.entry, node->data.sequence.items.start[i]))
            return false;
    }
    return true;
}

static bool judge_number(Judge* judge, int id, const char* word) {
    // digits first: strtod alone would take nan, infinity and hexadecimals
    char* end = NULL;
    errno = 0;
    const bool digits = word[0] && !word[strspn(word, "0123456789+-.eE")];
    const double value = digits ? strtod(word, &end) : 0;
    if (!digits || *end)
        return tree_fault(judge->tree, id, judge->fault, "%s must be a number, not '%.64s'",
                          subject(judge), word);
    if (errno == ERANGE || !isfinite(value))
        return tree_fault(judge->tree, id, judge->fault,
                          "%s is %.64s, which is beyond the numbers of this machine",
                          subject(judge), word);

    const Range* range = range_find(judge->path);
    if (!range || range_holds(range, value))
        return true;
    char words[96];
    range_words(range, words);
    return tree_fault(judge->tree, id, judge->fault, "%s must be %s, not %.64s", subject(judge),
                      words, word);
}

static bool judge_name(Judge* judge, const cyaml_schema_value_t* schema, int id, const char* word) {
    char words[512];
    size_t length = 0;
    for (unsigned i = 0; i < schema->enumeration.count; i++) {
        const char* known = schema->enumeration.strings[i].str;
        if (strcmp(known, word) == 0)
            return true;
        length += (size_t)snprintf(words + length, sizeof words - length, "%s%s",
                                   length ? ", " : "", known);
    }
    const char* dot = strrchr(judge->path, '.');
    return tree_fault(judge->tree, id, judge->fault, "no %s '%.64s'; there are %s",
                      dot ? dot + 1 : judge->path, word, words);
}

static bool judge_text(Judge* judge, const cyaml_schema_value_t* schema, int id, size_t length) {
    if (length < schema->string.min)
        return tree_fault(judge->tree, id, judge->fault, "%s must not be empty", subject(judge));
    if (length > schema->string.max)
        return tree_fault(judge->tree, id, judge->fault, "%s must be at most %u bytes long",
                          subject(judge), schema->string.max);
    return true;
}

static bool judge_word(Judge* judge, const cyaml_schema_value_t* schema, int id) {
    const yaml_node_t* node = tree_node(judge->tree, id);
    if (node->type != YAML_SCALAR_NODE)
        return tree_fault(judge->tree, id, judge->fault, "%s must be one value, not %s",
                          subject(judge),
                          node->type == YAML_MAPPING_NODE ? "keys with values" : "a list");
    const char* word = (const char*)node->data.scalar.value;
    if (strlen(word) != node->data.scalar.length)
        return tree_fault(judge->tree, id, judge->fault, "%s has a zero byte in it",
                          subject(judge));

    if (schema->type == CYAML_FLOAT)
        return judge_number(judge, id, word);
    if (schema->type == CYAML_ENUM)
        return judge_name(judge, schema, id, word);
    if (schema->type == CYAML_BOOL)
        return strcmp(word, "true") == 0 || strcmp(word, "false") == 0 ||
               tree_fault(judge->tree, id, judge->fault, "%s must be true or false, not '%.64s'",
                          subject(judge), word);
    return judge_text(judge, schema, id, node->data.scalar.length);
}

static bool judge_value(Judge* judge, const cyaml_schema_value_t* schema, int node) {
    if (++judge->nodes > SCENE_NODES_MOST)
        return tree_fault(judge->tree, node, judge->fault,
                          "this scene is too large; at most %d values, please", SCENE_NODES_MOST);
    if (schema->type == CYAML_MAPPING)
        return judge_mapping(judge, schema, node);
    if (schema->type == CYAML_SEQUENCE || schema->type == CYAML_SEQUENCE_FIXED)
        return judge_list(judge, schema, node);
    return judge_word(judge, schema, node);
}

bool judge_scene(const SceneTree* tree, Fault* fault) {
    Judge judge = {.tree = tree, .fault = fault};
    return judge_value(&judge, scene_schema(), TREE_ROOT);
}
