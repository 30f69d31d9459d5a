/// Preloaded into the program by test_memory.sh: allocation number FAIL_AT fails, and the object
/// that asked for it is written to descriptor 9.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <execinfo.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

extern void* __libc_malloc(size_t size);
extern void* __libc_calloc(size_t count, size_t size);
extern void* __libc_realloc(void* old, size_t size);
extern void* __libc_memalign(size_t alignment, size_t size);

static atomic_long count;
static atomic_int asking;

/// The first object on the stack that is neither this one nor the library
/// of C or C++.
static const char* who_asked(void) {
    void* frame[24];
    Dl_info about, own;
    const int frames = backtrace(frame, 24);
    dladdr((void*)who_asked, &own);
    for (int k = 0; k < frames; k++)
        if (dladdr(frame[k], &about) && about.dli_fname && about.dli_fbase != own.dli_fbase &&
            !strstr(about.dli_fname, "/libc.so") && !strstr(about.dli_fname, "/libstdc++.so"))
            return about.dli_fname;
    return "libc.so";
}

static int fails(void) {
    const char* text = getenv("FAIL_AT");
    if (asking || !text || ++count != atol(text))
        return 0;
    asking = 1; // a backtrace allocates
    const char* name = who_asked();
    asking = 0;
    errno = ENOMEM;
    return write(9, name, strlen(name)) < 0 || write(9, "\n", 1) < 0 || 1;
}

void* malloc(size_t size) {
    return fails() ? NULL : __libc_malloc(size);
}

void* calloc(size_t number, size_t size) {
    return fails() ? NULL : __libc_calloc(number, size);
}

void* realloc(void* old, size_t size) {
    return fails() ? NULL : __libc_realloc(old, size);
}

void* aligned_alloc(size_t alignment, size_t size) {
    return fails() ? NULL : __libc_memalign(alignment, size);
}
