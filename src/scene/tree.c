#include "scene/tree.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH_MAX = 256 }; ///< libyaml takes time quadratic in the depth
static const size_t NO_LINE = (size_t)-1;

// What libyaml's reader complains about has an offset and no line.
static size_t line_at(const char* text, size_t size, size_t offset) {
    size_t line = 0;
    for (size_t i = 0; i < size && i < offset; i++)
        line += text[i] == '\n';
    return line;
}

// The line on which brackets lie more than DEPTH_MAX in each other, or NO_LINE. Those in comments
// and quotes are counted too, for a scene has few.
static size_t deep_line(const char* text, size_t size) {
    int depth = 0;
    for (size_t i = 0; i < size; i++) {
        if (text[i] == '[' || text[i] == '{')
            depth++;
        else if ((text[i] == ']' || text[i] == '}') && depth > 0)
            depth--;
        if (depth > DEPTH_MAX)
            return line_at(text, size, i);
    }
    return NO_LINE;
}

// A fault with the location of a line, which may be an override's.
static bool line_fault(const SceneTree* tree, size_t line, Fault* fault, const char* sentence) {
    if (line >= TREE_SET_LINE) {
        char location[sizeof fault->location];
        snprintf(location, sizeof location, "--set %s", tree->set[line - TREE_SET_LINE].text);
        return fault_set(fault, location, "%s", sentence);
    }
    if (tree->numbered)
        return fault_at(fault, tree->file, (long)line + 1, "%s", sentence);
    return fault_set(fault, tree->file, "%s", sentence);
}

static bool syntax_fault(const SceneTree* tree, const yaml_parser_t* parser, const char* text,
                         size_t size, Fault* fault) {
    // libyaml names the line after the last where the end is incomplete
    const size_t last = line_at(text, size, size > 0 ? size - 1 : 0);
    size_t line = parser->error == YAML_READER_ERROR ? line_at(text, size, parser->problem_offset)
                                                     : parser->problem_mark.line;
    if (line > last)
        line = last;
    char sentence[256];
    snprintf(sentence, sizeof sentence, "this is not YAML: %s",
             parser->problem ? parser->problem : "no memory to read it");
    return line_fault(tree, line, fault, sentence);
}

static bool nothing_follows(const SceneTree* tree, yaml_parser_t* parser, const char* text,
                            size_t size, Fault* fault) {
    yaml_document_t second;
    if (!yaml_parser_load(parser, &second))
        return syntax_fault(tree, parser, text, size, fault);

    const yaml_node_t* root = yaml_document_get_root_node(&second);
    const size_t line = root ? root->start_mark.line : 0;
    yaml_document_delete(&second);
    return !root || line_fault(tree, line, fault, "a second YAML document begins; give one only");
}

bool tree_parse(SceneTree* tree, const char* text, size_t size, Fault* fault) {
    const size_t deep = deep_line(text, size);
    if (deep != NO_LINE)
        return line_fault(tree, deep, fault, "no scene has so many brackets in each other");

    yaml_parser_t parser;
    if (!yaml_parser_initialize(&parser))
        return fault_set(fault, tree->file, "no memory to read it");
    yaml_parser_set_input_string(&parser, (const unsigned char*)text, size);

    const bool read = yaml_parser_load(&parser, &tree->document);
    const bool good = read ? nothing_follows(tree, &parser, text, size, fault)
                           : syntax_fault(tree, &parser, text, size, fault);
    yaml_parser_delete(&parser);
    return good;
}

const yaml_node_t* tree_node(const SceneTree* tree, int node) {
    const yaml_document_t* document = &tree->document;
    if (node < 1 || node > document->nodes.top - document->nodes.start)
        return NULL;
    return document->nodes.start + node - 1;
}

static bool is_word(const yaml_node_t* node, const char* word, size_t length) {
    return node->type == YAML_SCALAR_NODE && node->data.scalar.length == length &&
           memcmp(node->data.scalar.value, word, length) == 0;
}

int* tree_slot(const SceneTree* tree, int parent, const char* part, size_t length) {
    const yaml_node_t* node = tree_node(tree, parent);
    if (node->type == YAML_MAPPING_NODE) {
        yaml_node_pair_t* pair = node->data.mapping.pairs.start;
        for (; pair < node->data.mapping.pairs.top; pair++)
            if (is_word(tree_node(tree, pair->key), part, length))
                return &pair->value;
    } else if (node->type == YAML_SEQUENCE_NODE) {
        const long count = node->data.sequence.items.top - node->data.sequence.items.start;
        const long item = strtol(part, NULL, 10);
        if (length > 0 && strspn(part, "0123456789") == length && item < count)
            return node->data.sequence.items.start + item;
    }
    return NULL;
}

int tree_find(const SceneTree* tree, const char* path) {
    int node = TREE_ROOT;
    while (*path) {
        const size_t length = strcspn(path, ".");
        const int* slot = tree_slot(tree, node, path, length);
        if (!slot)
            break;
        node = *slot;
        path += length + (path[length] == '.');
    }
    return node;
}

static size_t line_of(const SceneTree* tree, int node) {
    const yaml_node_t* own = tree_node(tree, node);
    if (own->type == YAML_MAPPING_NODE) {
        const yaml_node_pair_t* pair = own->data.mapping.pairs.start;
        for (; pair < own->data.mapping.pairs.top; pair++) {
            const yaml_node_t* value = tree_node(tree, pair->value);
            if (value->start_mark.line >= TREE_SET_LINE)
                return value->start_mark.line;
        }
    }
    return own->start_mark.line;
}

bool tree_fault(const SceneTree* tree, int node, Fault* fault, const char* format, ...) {
    char sentence[sizeof fault->text];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(sentence, sizeof sentence, format, arguments);
    va_end(arguments);

    return line_fault(tree, line_of(tree, node), fault, sentence);
}

void tree_free(SceneTree* tree) {
    yaml_document_delete(&tree->document);
}
