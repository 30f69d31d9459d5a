/// Writes a tree as YAML again: what libcyaml then reads.
#include "world/scene_tree.h"

#include <stdlib.h>
#include <string.h>

typedef struct Text {
    char* byte;
    size_t size;
    size_t room;
} Text;

static int append(void* data, unsigned char* byte, size_t size) {
    Text* text = data;
    if (text->size + size > text->room) {
        text->room = 2 * (text->size + size);
        char* larger = realloc(text->byte, text->room);
        if (!larger)
            return 0;
        text->byte = larger;
    }
    memcpy(text->byte + text->size, byte, size);
    text->size += size;
    return 1;
}

static bool emit(yaml_emitter_t* emitter, yaml_event_t event) {
    return yaml_emitter_emit(emitter, &event);
}

static bool emit_node(yaml_emitter_t* emitter, const SceneTree* tree, int id);

static bool emit_mapping(yaml_emitter_t* emitter, const SceneTree* tree, const yaml_node_t* node) {
    yaml_event_t event;
    bool good = yaml_mapping_start_event_initialize(&event, NULL, NULL, 1, YAML_FLOW_MAPPING_STYLE);
    good = good && emit(emitter, event);

    const yaml_node_pair_t* pair = node->data.mapping.pairs.start;
    for (; good && pair < node->data.mapping.pairs.top; pair++)
        good = emit_node(emitter, tree, pair->key) && emit_node(emitter, tree, pair->value);

    return good && yaml_mapping_end_event_initialize(&event) && emit(emitter, event);
}

static bool emit_list(yaml_emitter_t* emitter, const SceneTree* tree, const yaml_node_t* node) {
    yaml_event_t event;
    bool good =
        yaml_sequence_start_event_initialize(&event, NULL, NULL, 1, YAML_FLOW_SEQUENCE_STYLE);
    good = good && emit(emitter, event);

    const yaml_node_item_t* item = node->data.sequence.items.start;
    for (; good && item < node->data.sequence.items.top; item++)
        good = emit_node(emitter, tree, *item);

    return good && yaml_sequence_end_event_initialize(&event) && emit(emitter, event);
}

static bool emit_scalar(yaml_emitter_t* emitter, const yaml_node_t* node) {
    yaml_event_t event;
    return yaml_scalar_event_initialize(&event, NULL, NULL, node->data.scalar.value,
                                        (int)node->data.scalar.length, 1, 1,
                                        YAML_DOUBLE_QUOTED_SCALAR_STYLE) &&
           emit(emitter, event);
}

static bool emit_node(yaml_emitter_t* emitter, const SceneTree* tree, int id) {
    const yaml_node_t* node = tree_node(tree, id);
    if (node->type == YAML_MAPPING_NODE)
        return emit_mapping(emitter, tree, node);
    if (node->type == YAML_SEQUENCE_NODE)
        return emit_list(emitter, tree, node);
    return emit_scalar(emitter, node);
}

static bool emit_all(yaml_emitter_t* emitter, const SceneTree* tree) {
    yaml_event_t event;
    return yaml_stream_start_event_initialize(&event, YAML_UTF8_ENCODING) && emit(emitter, event) &&
           yaml_document_start_event_initialize(&event, NULL, NULL, NULL, 1) &&
           emit(emitter, event) && emit_node(emitter, tree, TREE_ROOT) &&
           yaml_document_end_event_initialize(&event, 1) && emit(emitter, event) &&
           yaml_stream_end_event_initialize(&event) && emit(emitter, event);
}

char* tree_text(const SceneTree* tree, size_t* size) {
    Text text = {0};
    yaml_emitter_t emitter;
    bool good = yaml_emitter_initialize(&emitter);
    if (good) {
        yaml_emitter_set_output(&emitter, append, &text);
        yaml_emitter_set_unicode(&emitter, 1);
        yaml_emitter_set_width(&emitter, -1);
        good = emit_all(&emitter, tree);
    }
    yaml_emitter_delete(&emitter);
    ASSERT(good, "a judged tree can be written out, memory permitting");
    *size = text.size;
    return text.byte;
}
