/// Writes a tree as YAML again, for files that a person or another run reads.
#include "scene/tree.h"

#include "base/array.h"

typedef struct Text {
    char* byte;
    int size;
    int capacity;
} Text;

static int append(void* data, unsigned char* byte, size_t size) {
    Text* text = data;
    for (size_t i = 0; i < size; i++) {
        array_reserve(text->byte, text->size, text->capacity);
        text->byte[text->size++] = (char)byte[i];
    }
    return 1;
}

static bool emit(yaml_emitter_t* emitter, yaml_event_t event) {
    return yaml_emitter_emit(emitter, &event);
}

/// How a tree is written: every scalar quoted, or for people.
typedef struct Writer {
    yaml_emitter_t* emitter;
    const SceneTree* tree;
    bool for_people;
} Writer;

static bool emit_node(const Writer* writer, int id, int depth);

// For people the scene's keys and a balloon's stand on lines of their own.
static bool has_lines(const Writer* writer, int depth) {
    return writer->for_people && depth <= 2;
}

static bool emit_mapping(const Writer* writer, const yaml_node_t* node, int depth) {
    yaml_event_t event;
    bool good = yaml_mapping_start_event_initialize(&event, NULL, NULL, 1,
                                                    has_lines(writer, depth) && depth != 1
                                                        ? YAML_BLOCK_MAPPING_STYLE
                                                        : YAML_FLOW_MAPPING_STYLE);
    good = good && emit(writer->emitter, event);

    const yaml_node_pair_t* pair = node->data.mapping.pairs.start;
    for (; good && pair < node->data.mapping.pairs.top; pair++)
        good = emit_node(writer, pair->key, depth + 1) && emit_node(writer, pair->value, depth + 1);

    return good && yaml_mapping_end_event_initialize(&event) && emit(writer->emitter, event);
}

static bool emit_list(const Writer* writer, const yaml_node_t* node, int depth) {
    yaml_event_t event;
    bool good = yaml_sequence_start_event_initialize(
        &event, NULL, NULL, 1,
        has_lines(writer, depth) ? YAML_BLOCK_SEQUENCE_STYLE : YAML_FLOW_SEQUENCE_STYLE);
    good = good && emit(writer->emitter, event);

    const yaml_node_item_t* item = node->data.sequence.items.start;
    for (; good && item < node->data.sequence.items.top; item++)
        good = emit_node(writer, *item, depth + 1);

    return good && yaml_sequence_end_event_initialize(&event) && emit(writer->emitter, event);
}

static bool emit_scalar(const Writer* writer, const yaml_node_t* node) {
    yaml_event_t event;
    return yaml_scalar_event_initialize(
               &event, NULL, NULL, node->data.scalar.value, (int)node->data.scalar.length, 1, 1,
               writer->for_people ? node->data.scalar.style : YAML_DOUBLE_QUOTED_SCALAR_STYLE) &&
           emit(writer->emitter, event);
}

static bool emit_node(const Writer* writer, int id, int depth) {
    const yaml_node_t* node = tree_node(writer->tree, id);
    if (node->type == YAML_MAPPING_NODE)
        return emit_mapping(writer, node, depth);
    if (node->type == YAML_SEQUENCE_NODE)
        return emit_list(writer, node, depth);
    return emit_scalar(writer, node);
}

static bool emit_all(const Writer* writer) {
    yaml_event_t event;
    return yaml_stream_start_event_initialize(&event, YAML_UTF8_ENCODING) &&
           emit(writer->emitter, event) &&
           yaml_document_start_event_initialize(&event, NULL, NULL, NULL, 1) &&
           emit(writer->emitter, event) && emit_node(writer, TREE_ROOT, 0) &&
           yaml_document_end_event_initialize(&event, 1) && emit(writer->emitter, event) &&
           yaml_stream_end_event_initialize(&event) && emit(writer->emitter, event);
}

char* tree_text(const SceneTree* tree, bool for_people, size_t* size) {
    Text text = {0};
    yaml_emitter_t emitter;
    bool good = yaml_emitter_initialize(&emitter);
    if (good) {
        yaml_emitter_set_output(&emitter, append, &text);
        yaml_emitter_set_unicode(&emitter, 1);
        yaml_emitter_set_width(&emitter, -1);
        good =
            emit_all(&(Writer){&emitter, tree, for_people}) && append(&text, (unsigned char*)"", 1);
        text.size -= good;
    }
    yaml_emitter_delete(&emitter);
    if (!good) {
        free(text.byte);
        return NULL;
    }
    *size = (size_t)text.size;
    return text.byte;
}
