/// libFuzzer's entry: the target that FUZZ_TARGET names.
#include "targets.h"

#include "base/table.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    static const struct FuzzTarget* target;
    if (!target)
        target = table_row_of(fuzz_table, FUZZ_TARGETS, sizeof *fuzz_table, getenv("FUZZ_TARGET"));
    ASSERT(target, "FUZZ_TARGET names a row of fuzz_table");
    target->run(data, size);
    return 0;
}
