/// Rows by name, lists of names, and growing arrays.
#include "base/array.h"
#include "base/table.h"
#include "law.h"

typedef struct Row {
    const char* name;
    int number;
} Row;

static const Row table[] = {{"one", 1}, {"two", 2}, {"three", 3}};
static const Row* const pointers[] = {&table[0], &table[1], &table[2]};

static void rows_are_found_by_name(void** state) {
    (void)state;
    for (int k = 0; k < 3; k++) {
        assert_ptr_equal(table_row_of(table, 3, sizeof *table, table[k].name), &table[k]);
        assert_ptr_equal(table_find(pointers, 3, table[k].name), &table[k]);
    }
    assert_null(table_row_of(table, 3, sizeof *table, "thre"));
    assert_null(table_find(pointers, 2, "three"));
}

static void names_are_listed_and_cut_off(void** state) {
    (void)state;
    char names[64];
    assert_string_equal(table_names_of(table, 3, sizeof *table, names, sizeof names),
                        "one, two, three");
    assert_string_equal(table_names(pointers, 2, names, sizeof names), "one, two");
    assert_string_equal(table_names(pointers, 3, names, 12), "one, two, t");
    assert_string_equal(table_names(pointers, 0, names, sizeof names), "");
}

static void arrays_keep_their_elements_as_they_grow(void** state) {
    (void)state;
    enum { N = 1000 };
    int* item = NULL;
    int count = 0, capacity = 0, growths = 0;
    for (; count < N; count++) {
        const int before = capacity;
        array_reserve(item, count, capacity);
        growths += capacity != before;
        item[count] = count;
    }
    for (int k = 0; k < N; k++)
        assert_int_equal(item[k], k);
    assert_int_equal(growths, 7); // 16, 32 … 1024
    free(item);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_are_found_by_name),
        cmocka_unit_test(names_are_listed_and_cut_off),
        cmocka_unit_test(arrays_keep_their_elements_as_they_grow),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
