# make          build; where packages are missing, say the line that installs them
# make run      install what is missing, build, open the default scene (or render it to out/)
# make test     install what is missing, build, run all tests in both precisions
#               ONLY=contact: those with the word in their name
# make check    format, include layers, sizes and names, headers alone, warnings as errors with gcc and
#               clang, state hashes of all scenes with both, all tests under the address and
#               undefined-behavior sanitizers, those of threads under the thread sanitizer; ONLY as above;
#               then make fuzz
# make tidy     clang-tidy with the checks of src/.clang-tidy
# make fuzz     libFuzzer on the readers of files and of the command line, SECONDS (60) each
# make golden   write tests/golden/hashes.csv anew, after a change of bits on purpose
# make chart    chart speed against accuracy to out/chart, and the README files' picture and table
# make picture  draw the picture of the lab panel, assets/lab.png, anew
# make bench    measure and print speed, and what every shipped scene needs
# make reference   write the scene reference (assets/scenes/README.md) anew
# make format   rewrite the sources as clang-format has them
# make compile_commands.json   for editors and clang-tidy
# make clean    remove what was built
# make help     these lines
#
# build/balloon has a state of float, build/balloon-double of double; both come from src/.

# Debian 12's names; the only list of packages there is
BUILD_PACKAGES := gcc g++ pkg-config libassimp-dev libyaml-dev libcglm-dev libimgui-dev \
    libglfw3-dev libegl-dev libopengl-dev libpng-dev libbullet-dev libsuitesparse-dev
RUN_PACKAGES   := libegl1 libgl1 libgl1-mesa-dri ffmpeg gnuplot-nox
TEST_PACKAGES  := libcmocka-dev xvfb xdotool imagemagick
CHECK_PACKAGES := clang clang-format libclang-rt-14-dev llvm
TIDY_PACKAGES  := clang-tidy
LIBRARIES      := assimp yaml-0.1 cglm imgui glfw3 egl opengl libpng bullet bullet-float64 CHOLMOD

BUILD    ?= build
CC       := $(if $(filter default,$(origin CC)),gcc,$(CC))
CXX      := $(if $(filter default,$(origin CXX)),g++,$(CXX))
EXTRA    ?=
JOBS     := $(shell nproc 2>/dev/null || echo 2)
PREFIX   ?= /usr/local

# Bits: no contraction and no reassociation, so that every compiler rounds alike; without errno and
# traps, square roots stay in loops.
BITS     := -O2 -ffp-contract=off -fno-math-errno -fno-trapping-math
WARN     := -Wall -Wextra -Wpedantic -Wshadow -Wvla -Wimplicit-fallthrough -Wundef -Wno-psabi
WARN_C   := -Wstrict-prototypes -Wmissing-prototypes
CPPFLAGS := -Isrc -D_POSIX_C_SOURCE=200809L -MMD -MP
# no warnings about libraries' headers
includes  = $(patsubst -I%,-isystem %,$(shell pkg-config --cflags-only-I imgui bullet 2>/dev/null))
# Bullet is one library for each precision; they do not mix
bullet_float  = -lBulletSoftBody -lBulletDynamics -lBulletCollision -lLinearMath
bullet_double = $(addsuffix -float64,$(bullet_float))
libraries = -lassimp -lyaml -limgui -lstb -lglfw -lEGL -lOpenGL -lpng -lcholmod \
    -lsuitesparseconfig -lm -ldl -lpthread

SOURCES  := $(filter-out src/main.c,$(wildcard src/*/*.c src/*/*/*.c src/*/*.cpp src/*/*/*.cpp))
# kernels are compiled for the baseline of an architecture, and again for newer machines (base/cpu.h)
KERNELS  := $(if $(filter x86_64,$(shell uname -m)),$(wildcard src/*/*_kernel.c src/*/*/*_kernel.c src/force/material_*.c))
HEADERS  := $(wildcard src/*/*.h src/*/*/*.h)
# a header that a source includes first is checked by that source's compilation
FIRST    := $(shell awk 'FNR == 1 { found = 0 } /^\#include/ && !found { found = 1; gsub(/"/, "", $$2); print "src/" $$2 }' \
    $(SOURCES))
ALONE    := $(filter-out $(FIRST),$(HEADERS))
# one precision, quick to compile; the plain build's tests run in both. The readers of files and of the
# command line also count what they reach, which leads libFuzzer: one tree serves both
SANITIZED := BUILD=build/sanitized CC=clang CXX=clang++ COVERAGE=-fsanitize=fuzzer-no-link \
    EXTRA="-Werror -O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all"
READERS   := base/% mesh/% scene/% cli/% world/record.%
COVERAGE  :=
# the sources for stepping a world, without the programs
STEPPING  := $(filter-out $(addprefix src/,lab/% view/% draw/% hud/% show/% cli/%),$(SOURCES))
# the many test programs are linked in a third of the time where there is gold
GOLD    := $(if $(shell command -v ld.gold),-fuse-ld=gold)
ONLY    ?=
UNIT     := $(basename $(notdir $(wildcard tests/unit/test_*$(ONLY)*.c)))
SCENE   ?=
SECONDS ?= 60

.PHONY: all help run test check tidy fuzz golden bench chart picture reference format clean install programs tests hashes \
    packages-build packages-run packages-test packages-check headers
.DELETE_ON_ERROR:

all:
	$(call say_missing,$(BUILD_PACKAGES),$(LIBRARIES),gcc g++ pkg-config)
	@$(MAKE) --no-print-directory -j$(JOBS) programs

help:
	@sed -n '/^# make /,/^#$$/{/^#$$/d;s/^# \?//;p}' Makefile

run: packages-build packages-run
	@$(MAKE) --no-print-directory -j$(JOBS) programs
	@if [ -n "$$DISPLAY$$WAYLAND_DISPLAY" ]; then $(BUILD)/balloon $(SCENE); \
	else echo "There is no display: 10 s of the scene go to out/"; \
	    $(BUILD)/balloon render $(or $(SCENE),party) --seconds 10 --out out; fi

test: packages-build packages-run packages-test
	@$(MAKE) --no-print-directory -j$(JOBS) programs tests
	@JOBS=$(JOBS) tests/run.sh $(BUILD) $(ONLY)

# gcc's build is that of the tests, or is made here; clang's is compared with the same
# table of hashes, with the baseline kernels and two threads
check: packages-build packages-run packages-test packages-check
	@tests/format.sh
	@tests/layers.sh
	@$(MAKE) --no-print-directory -j$(JOBS) headers
	@$(MAKE) --no-print-directory -j$(JOBS) EXTRA="$(or $(EXTRA),-Werror)" programs hashes
	@tests/structure.sh $(BUILD)
	@JOBS=$(JOBS) tests/hashes.sh check $(BUILD)
	@echo "clang, warnings as errors"
	@$(MAKE) --no-print-directory -j$(JOBS) BUILD=build/clang CC=clang CXX=clang++ SOURCES="$(STEPPING)" \
	    EXTRA="-Werror -g1" hashes
	@BALLOON_CPU=baseline THREADS=2 JOBS=$(JOBS) tests/hashes.sh check-own build/clang
	@echo "sanitizers"
	@$(MAKE) --no-print-directory -j$(JOBS) BUILD=build/threads CC=clang CXX=clang++ SOURCES="$(STEPPING)" \
	    EXTRA="-Werror -O1 -g1 -fsanitize=thread" build/threads/float/tests/test_crew
	@build/threads/float/tests/test_crew
	@$(MAKE) --no-print-directory -j$(JOBS) $(SANITIZED) build/sanitized/balloon $(UNIT:%=build/sanitized/float/tests/%)
	@cp $(BUILD)/balloon-double build/sanitized/
	@JOBS=$(JOBS) tests/hashes.sh touch build/sanitized
	@SHORT=1 PRECISIONS=float JOBS=$(JOBS) tests/run.sh build/sanitized $(ONLY)
	@[ -n "$(ONLY)" ] || $(MAKE) --no-print-directory fuzz

tidy:
	$(call install_missing,$(BUILD_PACKAGES) $(TIDY_PACKAGES),$(LIBRARIES),clang-tidy)
	@find src -name '*.c' | sort | xargs -P $(JOBS) -n 10 sh -c 'clang-tidy --quiet "$$@" -- \
	    -std=c17 -Isrc -D_POSIX_C_SOURCE=200809L $(includes) 2>/dev/null' clang-tidy

fuzz: packages-build packages-check
	@$(MAKE) --no-print-directory -j$(JOBS) $(SANITIZED) build/sanitized/float/fuzz
	@JOBS=$(JOBS) tests/fuzz/fuzz.sh build/sanitized/float/fuzz $(SECONDS)

golden:
	$(call say_missing,$(BUILD_PACKAGES),$(LIBRARIES),gcc g++ pkg-config)
	@$(MAKE) --no-print-directory -j$(JOBS) hashes
	@JOBS=$(JOBS) tests/hashes.sh renew $(BUILD)

compile_commands.json: Makefile
	@$(MAKE) --no-print-directory -Bn BUILD=build/none EXTRA= programs tests | tests/compile_commands.sh >$@

bench: packages-build
	@$(MAKE) --no-print-directory -j$(JOBS) programs
	@tests/bench.sh $(BUILD)

chart: packages-build packages-run
	@$(MAKE) --no-print-directory -j$(JOBS) programs
	@mkdir -p out
	@$(BUILD)/balloon chart --out out/chart
	@cp out/chart/sphere-gas.png assets/chart.png
	@sed -i -e '/^<!-- chart:/,/^<!-- end of chart/{//!d}' -e '/^<!-- chart:/r out/chart/chart.md' src/lab/README.md

picture: packages-build packages-run
	@$(MAKE) --no-print-directory -j$(JOBS) $(BUILD)/balloon
	@$(BUILD)/balloon render sphere-gas --lab --overlay --time --fps 1600 --seconds 0.2 --method euler \
	    --step 2e-4 --set "title=Four times the gas" --set balloons.0.model=icosphere:3 \
	    --set "balloons.0.inflation.fill={to: 4, seconds: 0.15}" \
	    --set "camera.eye=[0, 0.05, 0.8]" --out assets/lab.png

reference: packages-build
	@$(MAKE) --no-print-directory -j$(JOBS) $(BUILD)/balloon
	@mkdir -p out
	@$(BUILD)/balloon keys >out/keys.md
	@sed -i -e '/^<!-- keys:/,/^<!-- end of keys/{//!d}' -e '/^<!-- keys:/r out/keys.md' assets/scenes/README.md

format: packages-check
	find src tests/unit -name "*.[ch]" -o -name "*.[ch]pp" | xargs clang-format -i

clean:
	rm -rf build out

install: all
	install -d $(DESTDIR)$(PREFIX)/bin $(DESTDIR)$(PREFIX)/share/balloon
	install $(BUILD)/balloon $(BUILD)/balloon-double $(DESTDIR)$(PREFIX)/bin
	cp -r assets shaders $(DESTDIR)$(PREFIX)/share/balloon

# --- packages: installs those that are missing, with sudo when not root, and prints the command ----

# missing: packages that are not there, or on other systems libraries $(2) and commands $(3)
define find_missing
missing=""; debian=""; \
if command -v dpkg-query >/dev/null && command -v apt-get >/dev/null; then debian=1; \
    for p in $(1); do dpkg-query -W -f='$${db:Status-Status}' $$p 2>/dev/null | grep -qx installed \
        || missing="$$missing $$p"; done; \
else \
    for l in $(2); do pkg-config --exists $$l 2>/dev/null || missing="$$missing $$l"; done; \
    for c in $(3); do command -v $$c >/dev/null || missing="$$missing $$c"; done; \
fi; \
if [ -n "$$missing" ] && [ -z "$$debian" ]; then \
    echo "This is no Debian; please install these first:$$missing" >&2; exit 1; fi
endef

define say_missing
@$(call find_missing,$(1),$(2),$(3)); \
[ -z "$$missing" ] || { echo "Packages are missing; type: sudo apt-get install$$missing" >&2; exit 1; }
endef

define install_missing
@$(call find_missing,$(1),$(2),$(3)); \
if [ -n "$$missing" ]; then \
    sudo=""; [ "$$(id -u)" = 0 ] || sudo="sudo"; \
    echo "Installing$$missing ($${sudo:-as root})"; \
    $$sudo apt-get update -qq && DEBIAN_FRONTEND=noninteractive \
        $$sudo apt-get install -y -qq --no-install-recommends $$missing >/dev/null || { \
        echo "Could not install:$$missing" >&2; exit 1; }; fi
endef

packages-build:
	$(call install_missing,$(BUILD_PACKAGES),$(LIBRARIES),gcc g++ pkg-config)
packages-run:
	$(call install_missing,$(RUN_PACKAGES),,ffmpeg gnuplot)
packages-test:
	$(call install_missing,$(TEST_PACKAGES),cmocka,Xvfb xdotool import)
packages-check:
	$(call install_missing,$(CHECK_PACKAGES),,clang clang-format)

# --- one set of rules for each precision -----------------------------------------------------------

define precision # $(1): float or double, $(2): its program, $(3): its flag
$(2)_objects := $$(patsubst src/%,$$(BUILD)/$(1)/%.o,$$(SOURCES)) \
    $$(patsubst src/%,$$(BUILD)/$(1)/%.v3.o,$$(KERNELS))

$$(addprefix $$(BUILD)/$(1)/,$$(addsuffix .o,$$(READERS))): reader := $$(COVERAGE)

$$(BUILD)/$(1)/%.c.o: src/%.c
	@mkdir -p $$(@D)
	@echo "  $$@"
	@$$(CC) -std=c17 -g $$(BITS) $$(WARN) $$(WARN_C) $$(EXTRA) $$(reader) $(3) $$(CPPFLAGS) $$(includes) -c $$< -o $$@

$$(BUILD)/$(1)/%.c.v3.o: src/%.c
	@mkdir -p $$(@D)
	@echo "  $$@"
	@$$(CC) -std=c17 -g $$(BITS) -march=x86-64-v3 -DKERNEL_V3 $$(WARN) $$(WARN_C) $$(EXTRA) $(3) $$(CPPFLAGS) \
	    $$(includes) -c $$< -o $$@

$$(BUILD)/$(1)/%.cpp.o: src/%.cpp
	@mkdir -p $$(@D)
	@echo "  $$@"
	@$$(CXX) -std=c++17 -g $$(BITS) $$(WARN) $$(EXTRA) $$(reader) $(3) $$(CPPFLAGS) $$(includes) -c $$< -o $$@

$$(BUILD)/$(1)/libballoon.a: $$($(2)_objects)
	@rm -f $$@
	@$$(AR) rcs $$@ $$^

$$(BUILD)/$(2): $$(BUILD)/$(1)/main.c.o $$(BUILD)/$(1)/libballoon.a
	@echo "  $$@"
	@$$(CXX) $$(EXTRA) $$^ $$(bullet_$(1)) $$(libraries) -o $$@

$$(BUILD)/$(1)/fuzz: tests/fuzz/fuzz.c tests/fuzz/targets.h $$(BUILD)/$(1)/libballoon.a
	@echo "  $$@"
	@$$(CC) -std=c17 -g $$(BITS) $$(WARN) $$(EXTRA) $(3) -Isrc -D_POSIX_C_SOURCE=200809L -c $$< -o $$@.o
	@$$(CXX) $$(EXTRA) -fsanitize=fuzzer $$@.o $$(BUILD)/$(1)/libballoon.a $$(bullet_$(1)) $$(libraries) -o $$@

$$(BUILD)/$(1)/state_hash: tests/state_hash.c $$(BUILD)/$(1)/libballoon.a
	@echo "  $$@"
	@$$(CC) -std=c17 -g $$(BITS) $$(WARN) $$(EXTRA) $(3) -Isrc -D_POSIX_C_SOURCE=200809L -c $$< -o $$@.o
	@$$(CXX) $$(EXTRA) $$@.o $$(BUILD)/$(1)/libballoon.a $$(bullet_$(1)) $$(libraries) -o $$@

# tests are compiled without optimization, which is quicker; the library that they call is optimized
$$(BUILD)/$(1)/tests/%.o: tests/unit/%.c
	@mkdir -p $$(@D)
	@echo "  $$@"
	@$$(CC) -std=c17 -g $$(BITS) $$(WARN) $$(WARN_C) $$(EXTRA) -O0 $(3) $$(CPPFLAGS) -Itests/unit $$(includes) -c $$< -o $$@

$$(BUILD)/$(1)/tests/%: $$(BUILD)/$(1)/tests/%.o $$(BUILD)/$(1)/libballoon.a
	@echo "  $$@"
	@$$(CXX) $$(EXTRA) $$(GOLD) $$(link_flags) $$^ $$(bullet_$(1)) $$(libraries) -lcmocka -o $$@

# one test counts allocations
$$(BUILD)/$(1)/tests/test_allocation: link_flags := $$(foreach f,malloc calloc realloc aligned_alloc,-Wl,--wrap=$$f)

programs: $$(BUILD)/$(2)
hashes: $$(BUILD)/$(1)/state_hash
tests: $$(UNIT:%=$$(BUILD)/$(1)/tests/%)
.SECONDARY: $$(UNIT:%=$$(BUILD)/$(1)/tests/%.o)
endef

$(eval $(call precision,float,balloon,))
$(eval $(call precision,double,balloon-double,-DBALLOON_DOUBLE))

# each header that no source includes first compiles alone, in both precisions
headers: $(ALONE:src/%=build/headers/%.ok)
build/headers/%.ok: src/% $(HEADERS)
	@mkdir -p $(@D)
	@for flag in -DBALLOON_FLOAT -DBALLOON_DOUBLE; do \
	    $(CC) -std=c17 $(WARN) -Werror $$flag -Isrc -D_POSIX_C_SOURCE=200809L -fsyntax-only -x c $< || exit 1; done
	@touch $@

-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
