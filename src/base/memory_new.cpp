#include <new>

#include "base/memory_missing.h"

static void end_program() {
    memory_missing("an object of C++");
}

void memory_missing_in_new() {
    std::set_new_handler(end_program);
}
