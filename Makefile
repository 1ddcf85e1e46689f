# roughlight: `make` builds, `make test` tests, `make report` does the main job; `make help` lists the rest.
#
# Variables that may be given: CC CXX CFLAGS CXXFLAGS CPPFLAGS LDFLAGS PREFIX DESTDIR, and
#   BUILD=dir          where everything made goes, in this tree       (build; build/sanitize-... with SANITIZE)
#   SANITIZE=list      compile with -fsanitize=list                   make SANITIZE=address,undefined test
#   WERROR=1           warnings are errors
#   F=names            only these of `make faults`: d-value g-reference; or of `make fuzz`: scene
#   SECONDS=600        how long `make fuzz` runs each
#   T=names            only these tests: module or module/name        make test T="scene/mesh model"
#   QUICK=1            a smaller, quicker `make report` or `make bench`
#   FULL=1             `make report` or `make bench` on the full grids: hours; may be interrupted, and goes on where it was
#   SETUP=check        say what is missing, install nothing
#   V=1                show the commands

VERSION := 0.1.0

comma := ,
BUILD ?= build$(if $(SANITIZE),/sanitize-$(subst $(comma),-,$(SANITIZE)))
GEN := $(BUILD)/gen
PREFIX ?= /usr/local
Q := $(if $(V),,@)

# `cc`, make's own default, says nothing about which compiler it is; and the C++ compiler must be of the same
# family as the C compiler, because their sanitizers' run-time libraries do not mix.
ifeq ($(origin CC),default)
CC := gcc
endif
ifeq ($(origin CXX),default)
CXX := $(if $(findstring clang,$(CC)),$(subst clang,clang++,$(CC)),g++)
endif
PKG_CONFIG ?= pkg-config
export CC CPPFLAGS PKG_CONFIG SETUP

.DELETE_ON_ERROR:
MAKEFLAGS += --no-builtin-rules

.PHONY: all FORCE
## Build the program (the default)
all:

# ---- Sources ------------------------------------------------------------------------------------------------

# Found by wildcard: a new file needs no line here. Everything but main goes into one archive, which the program and
# every test link against.
MAIN := $(wildcard src/cli/main.c)
LIB_SOURCES := $(sort $(filter-out $(MAIN),$(wildcard src/*/*.c studies/*.c)))
SHIM_SOURCE := $(wildcard src/image/oiio.cpp)
TEST_SUPPORT := $(wildcard tests/support/*.c)
# Harnesses of fuzzers: linked with this one file, which replays their corpora, they are tests like the others.
REPLAY := tests/fuzz/replay.c
FUZZERS := $(sort $(filter-out $(REPLAY) tests/fuzz/test_%,$(wildcard tests/fuzz/*.c)))
TEST_SOURCES := $(sort $(filter-out $(TEST_SUPPORT),$(wildcard tests/*/test_*.c)) $(FUZZERS))
TEST_SCRIPTS := $(sort $(wildcard tests/*/test_*.sh))
# The programs that write the exact answers of the hard cases: functions of the probe; lights seen from a point.
EXACT_LINES_SOURCES := $(wildcard tests/hard/exact_lines*.c)
EXACT_SOURCES := $(filter-out $(EXACT_LINES_SOURCES),$(wildcard tests/hard/exact*.c))
C_SOURCES := $(MAIN) $(LIB_SOURCES) $(TEST_SUPPORT) $(TEST_SOURCES) $(REPLAY) $(EXACT_SOURCES) $(EXACT_LINES_SOURCES)
ALL_SOURCES := $(C_SOURCES) $(SHIM_SOURCE) $(wildcard .ci/*.c) $(wildcard src/*/*.h studies/*.h tests/*/*.h)

object = $(patsubst %,$(BUILD)/obj/%.o,$(basename $1))
LIBRARY := $(BUILD)/libroughlight.a
# Linked into every program: nothing, unless the program is to be sanitized (the file says why).
EXTRA := $(if $(SANITIZE),$(call object,.ci/keep-libraries.c))
PROGRAM := $(if $(MAIN),$(BUILD)/roughlight)
SHIM := $(if $(SHIM_SOURCE),$(BUILD)/roughlight-oiio.so)

# T names tests as module/name or module; nothing given means all.
test_names = $(patsubst tests/%,%,$(subst /test_,/,$(basename $1)))
select = $(foreach file,$1,$(if $(if $(T),$(filter $(T) $(T:=/%),$(call test_names,$(file))),all),$(file)))
TEST_PROGRAMS := $(patsubst tests/%.c,$(BUILD)/tests/%,$(call select,$(TEST_SOURCES)))
TESTS := $(sort $(TEST_PROGRAMS) $(call select,$(TEST_SCRIPTS)))

# ---- Flags --------------------------------------------------------------------------------------------------

# What the code relies on; the user's CFLAGS and so on come after it.
# _GNU_SOURCE: dladdr, realpath and sched_getaffinity are outside of ISO C, and one macro declares them all.
# -fno-math-errno lets sqrt become one instruction. Never -ffast-math: it would drop the checks for nan and infinity.
# -ffp-contract=off: the same bits from gcc and clang, whatever -march says.
# -MMD -MP: each object notes its headers in a .d file, so that touching a header rebuilds its users only.
WARNINGS := -Wall -Wextra -Wpedantic $(if $(WERROR),-Werror)
C_WARNINGS := -Wstrict-prototypes -Wmissing-prototypes
SANITIZER := $(if $(SANITIZE),-fsanitize=$(SANITIZE) -fno-sanitize-recover=all -fno-omit-frame-pointer)
SHIM_SANITIZER := $(if $(SANITIZE),-fno-sanitize=vptr$(if $(findstring clang,$(CXX)),$(comma)function))
COMMON := -fno-math-errno -ffp-contract=off $(WARNINGS) $(SANITIZER)
CFLAGS ?= -O2 -g
CXXFLAGS ?= $(CFLAGS)
# Inner loops are compiled once per instruction set and chosen when the program runs (src/base/simd.h): NAME_avx2.c and
# NAME_avx512.c get these flags. Elsewhere than on x86-64 they are plain C, and nothing calls them.
ifneq ($(findstring x86_64,$(shell $(CC) -dumpmachine)),)
AVX2_FLAGS := -mavx2 -mfma
AVX512_FLAGS := -mavx512f -mavx512dq -mavx512bw -mavx512vl -mfma -mprefer-vector-width=512
endif
# Recursive: LIB_CFLAGS and the like come from packages.mk, below.
C_FLAGS = -std=c17 -D_GNU_SOURCE -Isrc -I. -I$(BUILD) $(LIB_CFLAGS) $(CPPFLAGS) \
	-fopenmp $(COMMON) $(C_WARNINGS) $(CFLAGS)
# No check of vptr, nor of clang's function: the run-time library for them comes with a main program of C++ only, and
# ours is C.
CXX_FLAGS = -std=c++17 -Isrc $(SHIM_CFLAGS) $(CPPFLAGS) -fPIC $(COMMON) $(SHIM_SANITIZER) $(CXXFLAGS)
# --as-needed: a program loads the libraries it calls and no others, which is most of its start-up time. OpenImageIO,
# OSMesa and EGL are not linked at all but loaded when first used.
# clang's address sanitizer must find __cxa_throw when a program starts, else it ends the program when a library that was
# loaded later throws, as OpenImageIO does over a damaged file.
CLANG_SANITIZER := $(if $(and $(SANITIZE),$(findstring clang,$(CC))),-Wl$(comma)--no-as-needed -lstdc++)
C_LINK = $(CC) -fopenmp $(SANITIZER) $(CFLAGS) $(if $(EXTRA),-Wl$(comma)--export-dynamic-symbol=dlclose) \
	$(CLANG_SANITIZER) -Wl,--as-needed $(LDFLAGS)
LIBS = $(LIB_LIBS) -lembree3 -lcubature -lm -lpthread -ldl

# ---- Set-up and generated files -------------------------------------------------------------------------------

# Puts $1 into the file that is being made, unless that is what it holds: users of an unchanged file stay up to date.
define write_if_changed
	$(file >$@.new,$1)@cmp -s $@.new $@ && rm $@.new || mv $@.new $@
endef
FORCE:

# packages.mk holds the libraries' flags. It is an included makefile, so make makes it first, which is when the set-up
# (see .ci/setup) takes place, and then reads it. Goals that compile nothing go without it.
LIB_MODULES := libcyaml yaml-0.1 gsl sqlite3 assimp sleef
HEADER_MODULES := osmesa egl
NO_COMPILE := help clean uninstall setup format format-check fuzz
GOALS := $(or $(MAKECMDGOALS),all)
# A report by itself builds on all processors: nothing is timed before all is built.
MAKEFLAGS += $(if $(filter-out report,$(GOALS)),,-j$(shell nproc))
PURPOSES := build $(filter test report,$(patsubst hard%,test,$(GOALS))) $(if $(filter lint tidy cppcheck,$(GOALS)),lint test) \
	$(if $(findstring clang,$(CC)),clang)
ifneq ($(filter-out $(NO_COMPILE),$(GOALS)),)
include $(GEN)/packages.mk
endif

# -isystem instead of -I: warnings are about our own code.
packages_mk = \
	for name in 'LIB_CFLAGS --cflags $(LIB_MODULES) $(HEADER_MODULES)' 'LIB_LIBS --libs $(LIB_MODULES)' \
		'SHIM_CFLAGS --cflags OpenImageIO' 'SHIM_LIBS --libs OpenImageIO' \
		'TEST_CFLAGS --cflags cmocka' 'TEST_LIBS --libs cmocka'; do \
		echo "$${name%% *} := $$($(PKG_CONFIG) $${name\#* } 2>/dev/null | sed 's/-I */-isystem /g')"; \
	done

$(GEN)/packages.mk: FORCE
	@.ci/setup $(PURPOSES)
	@mkdir -p $(@D)
	@{ $(packages_mk); } >$@.new; cmp -s $@.new $@ && rm $@.new || mv $@.new $@

# Everything compiled depends on this file: other flags or another compiler (or version of it) rebuild it.
$(GEN)/flags: FORCE
	$(call write_if_changed,$(shell $(CC) --version | head -n 1) $(CC) $(C_FLAGS) $(C_LINK) $(LIBS) \
		$(AVX2_FLAGS) $(AVX512_FLAGS) $(CXX) $(CXX_FLAGS) $(LDFLAGS) $(SHIM_LIBS) $(TEST_CFLAGS) $(TEST_LIBS))

# The archive depends on this one: a source that was removed leaves nothing newer than the archive.
$(GEN)/objects: FORCE
	$(call write_if_changed,$(call object,$(LIB_SOURCES)))

# #include "gen/version.h". Included by one source only, so that a commit rebuilds no more than that. Outside of a clone (in a tarball, even
# when it lies inside somebody else's clone) the commit is "unknown".
# What a program measures depends on what it was built from, which a commit does not change: names and contents of the sources are
# hashed, and the instruction sets that C_FLAGS does not show. Shaders are read, and hashed, by the program when it runs.
CODE := $(sort $(wildcard src/*/*.c src/*/*.h src/*/*.cpp studies/*.c studies/*.h))
code_hash = $(shell { echo '$(AVX2_FLAGS) $(AVX512_FLAGS)'; sha256sum $(CODE); } | sha256sum | cut -c 1-16)
in_clone = $(shell [ "$$(git rev-parse --show-cdup 2>&1)" = "" ] && echo yes)
quoted = "$(subst ",\",$(subst \,\\,$(strip $1)))"
define version_h
/* Made by the Makefile. */
#define RL_VERSION "$(VERSION)"
#define RL_COMMIT "$(or $(if $(in_clone),$(shell git rev-parse --short=12 HEAD 2>/dev/null)),unknown)"
#define RL_DIRTY $(if $(and $(in_clone),$(shell git status --porcelain --untracked-files=no 2>/dev/null)),1,0)
#define RL_CODE "$(code_hash)"
#define RL_COMPILER $(call quoted,$(shell $(CC) --version | head -n 1))
#define RL_CFLAGS $(call quoted,$(C_FLAGS))
endef
$(GEN)/version.h: FORCE
	$(call write_if_changed,$(version_h))

# ---- Compiling and linking ------------------------------------------------------------------------------------

all: $(LIBRARY) $(PROGRAM) $(SHIM)

# version.h must exist before anything is compiled for the first time; later on the .d files know who uses it.
$(BUILD)/obj/%.o: %.c $(GEN)/flags | $(GEN)/version.h
	@mkdir -p $(@D)
	$(if $(V),,@echo "  CC      $<")
	$(Q)$(CC) $(C_FLAGS) $(SIMD_FLAGS) $(TEST_FLAGS) -MMD -MP -c $< -o $@

$(BUILD)/obj/src/%_avx2.o $(BUILD)/tidy/src/%_avx2.c.ok: SIMD_FLAGS = $(AVX2_FLAGS)
$(BUILD)/obj/src/%_avx512.o $(BUILD)/tidy/src/%_avx512.c.ok: SIMD_FLAGS = $(AVX512_FLAGS)

$(BUILD)/obj/%.o: %.cpp $(GEN)/flags
	@mkdir -p $(@D)
	$(if $(V),,@echo "  CXX     $<")
	$(Q)$(CXX) $(CXX_FLAGS) -MMD -MP -c $< -o $@

$(BUILD)/obj/tests/%: TEST_FLAGS = -Itests $(TEST_CFLAGS)

$(LIBRARY): $(call object,$(LIB_SOURCES)) $(GEN)/objects
	$(if $(V),,@echo "  AR      $@")
	$(Q)rm -f $@ && $(AR) rcs $@ $(filter %.o,$^)

# $1: what follows objects and archive.
define link
	@mkdir -p $(@D)
	$(if $(V),,@echo "  LINK    $@")
	$(Q)$(C_LINK) $(filter %.o,$^) $(filter %.a,$^) $1 -o $@
endef

$(BUILD)/roughlight: $(call object,$(MAIN)) $(EXTRA) $(LIBRARY)
	$(call link,$(LIBS))

# The one file of C++; the program loads it when it first reads or writes an image.
$(BUILD)/roughlight-oiio.so: $(call object,$(SHIM_SOURCE))
	$(if $(V),,@echo "  LINK    $@")
	$(Q)$(CXX) -shared -fPIC $(SANITIZER) $(SHIM_SANITIZER) $(CXXFLAGS) -Wl,--as-needed $(LDFLAGS) $^ $(SHIM_LIBS) -o $@

$(BUILD)/tests/%: $(BUILD)/obj/tests/%.o $(call object,$(TEST_SUPPORT)) $(EXTRA) $(LIBRARY)
	$(call link,$(LIBS) $(TEST_LIBS))
$(FUZZERS:%.c=$(BUILD)/%): $(call object,$(REPLAY))

$(BUILD)/tests/hard/exact: $(call object,$(EXACT_SOURCES)) $(EXTRA)
$(BUILD)/tests/hard/exact_lines: $(call object,$(EXACT_LINES_SOURCES)) $(EXTRA)
$(BUILD)/tests/hard/exact $(BUILD)/tests/hard/exact_lines:
	$(call link,-lmpfr -lgmp -lm)

# The same with libFuzzer; see `make fuzz`.
$(BUILD)/fuzzers/%: $(BUILD)/obj/tests/fuzz/%.o $(EXTRA) $(LIBRARY)
	$(call link,-fsanitize=fuzzer $(LIBS) $(TEST_LIBS))

# What tests take the place of: the harness of scenes reads no mesh files, and makes small shapes.
$(BUILD)/tests/fuzz/scene $(BUILD)/fuzzers/scene: TEST_LIBS += -Wl,--wrap=rl_mesh_load,--wrap=rl_shape_build
# It plants normals of another R_r than was asked for.
$(BUILD)/tests/studies/test_distribution: TEST_LIBS += -Wl,--wrap=rl_ellipsoid_make
# It has a clock of its own.
$(BUILD)/tests/measure/test_timing: TEST_LIBS += -Wl,--wrap=clock_gettime

# Otherwise make would delete the tests' objects as intermediate files.
.SECONDARY:

-include $(patsubst %.o,%.d,$(call object,$(C_SOURCES) $(SHIM_SOURCE)))

# ---- Tests and the report ---------------------------------------------------------------------------------------

# How much of the studies' grids report and bench measure.
$(if $(and $(QUICK),$(FULL)),$(error QUICK and FULL: one of them, not both))
grid = $(if $(QUICK),--quick)$(if $(FULL),--full)

.PHONY: test report bench hard hard-answers check-errors faults fuzz
## Build, and run every test, or those that T names
test: all $(TEST_PROGRAMS) $(BUILD)/tests/hard/exact \
	$(if $(filter tests/hard/test_exact_lines.sh,$(TESTS)),$(BUILD)/tests/hard/exact_lines)
	$(if $(TESTS),,$(if $(T),$(error no test is called '$(T)'; there are: \
		$(call test_names,$(TEST_SOURCES) $(TEST_SCRIPTS)))))
	@BUILD=$(BUILD) ROUGHLIGHT=$(BUILD)/roughlight .ci/run-tests $(TESTS)

# In short those that make bench measures at length, and those of effects: the report has four minutes.
benched := accuracy bare
brief := $(benched) effects fur interpolation visibility

## Run the studies and make build/report/index.html
report: all
	$(BUILD)/roughlight study run $$($(BUILD)/roughlight study list | tail -n +2 | cut -f 1 | grep -vx $(brief:%=-e %)) \
		--db $(BUILD)/results.db $(grid)
	$(BUILD)/roughlight study run $(brief) --db $(BUILD)/results.db $(or $(grid),--quick)
	$(BUILD)/roughlight study report --db $(BUILD)/results.db -o $(BUILD)/report

# The commands go to stderr: stdout is the tables, with an empty line between two.
## Integrators: time and true error; a plan's frame against bare OpenGL; tables and verdicts on stdout
bench: all
	@$(BUILD)/roughlight study run $(benched) --db $(BUILD)/results.db $(grid)
	@$(BUILD)/roughlight study export --db $(BUILD)/results.db -o $(BUILD)/tables
	@for table in accuracy_points accuracy_images accuracy_kernel bare; do cat $(BUILD)/tables/$$table.tsv; echo; done
	@awk -F '\t' 'NR == 1 || $$7 == "accuracy" || $$7 == "bare"' $(BUILD)/tables/claims.tsv

## The catalogue of hard cases against exact answers, in C and in GLSL: rows on stdout, exit 1 if one fails
hard: all $(BUILD)/tests/hard/test_lines
	@failed=0; $(BUILD)/roughlight hard || failed=1; $(BUILD)/tests/hard/test_lines >&2 || failed=1; exit $$failed

## Write exact answers and bounds into the catalogue of hard cases and its maps (tests/hard), from MPFR
hard-answers: $(BUILD)/tests/hard/exact $(BUILD)/tests/hard/exact_lines
	$(BUILD)/tests/hard/exact $(wildcard tests/hard/*.tsv)
	$(BUILD)/tests/hard/exact --maps tests/hard/maps
	$(BUILD)/tests/hard/exact_lines tests/hard/lights/lights.tsv

# Before anything is built for it.
unknown = $(filter-out $1,$(F:.patch=))
check_names = $(if $(and $(unknown),$(filter $2,$(GOALS))),$(error no $3 is called '$(unknown)'; there are: $1))
$(call check_names,$(patsubst tests/faults/%.patch,%,$(sort $(wildcard tests/faults/*.patch))),faults,fault)

## Has an error metric changed since tests/baseline.tsv? Rows on stdout, exit 1 if one is worse
check-errors: all
	@$(BUILD)/roughlight study check

## Plant faults (tests/faults) one by one: does check-errors see each? Some 20 s each; rows on stdout
faults: all
	@BUILD=$(BUILD) tests/faults/run.sh $(F)

all_fuzzers := $(FUZZERS:tests/fuzz/%.c=%)
$(call check_names,$(all_fuzzers),fuzz,fuzzer)
fuzzers := $(or $(F),$(all_fuzzers))

# libFuzzer is clang's. Its objects go into a folder of their own; what is found, into its findings; inputs that reach new code, into its
# corpus, from where the next run goes on.
## Fuzz scene files, integrate, probe, merge and mesh files (libFuzzer), 10 min each; findings go to build/fuzz/findings
fuzz:
	@$(MAKE) --no-print-directory CC=$(if $(findstring clang,$(CC)),$(CC),clang) BUILD=$(BUILD)/fuzz \
		SANITIZE=fuzzer-no-link,address,undefined $(fuzzers:%=$(BUILD)/fuzz/fuzzers/%)
	@BUILD=$(BUILD)/fuzz tests/fuzz/run.sh $(or $(SECONDS),600) $(fuzzers)

# ---- Care of the sources ------------------------------------------------------------------------------------------

.PHONY: format format-check lint tidy cppcheck
## Lay out the sources (clang-format)
format:
	@.ci/setup format
	$(Q)$(if $(ALL_SOURCES),clang-format -i $(ALL_SOURCES))

## Fail if `make format` would change anything
format-check:
	@.ci/setup format
	$(Q)$(if $(ALL_SOURCES),clang-format --dry-run -Werror $(ALL_SOURCES))

## Look for faults in the sources (clang-tidy, cppcheck); fails on any finding
lint:
	@$(MAKE) --no-print-directory --keep-going --output-sync -j $(shell nproc) tidy cppcheck

# A source is looked at again when its object is newer, which is to say when it or one of its headers has changed.
tidy: $(patsubst %,$(BUILD)/tidy/%.ok,$(C_SOURCES) $(SHIM_SOURCE))
not_for_tidy := -Werror $(SANITIZER)
$(BUILD)/tidy/%.c.ok: $(BUILD)/obj/%.o .clang-tidy
	$(call tidy,$*.c,$(C_FLAGS) $(SIMD_FLAGS) -Itests $(TEST_CFLAGS))
$(BUILD)/tidy/%.cpp.ok: $(BUILD)/obj/%.o .clang-tidy
	$(call tidy,$*.cpp,$(CXX_FLAGS))

# $1: source, $2: its flags. clang-tidy counts the warnings in system headers on stderr, which nobody wants to
# know; what it finds goes to stdout.
define tidy
	@mkdir -p $(@D)
	$(if $(V),,@echo "  TIDY    $1")
	$(Q)clang-tidy --quiet $1 -- -Wno-unknown-warning-option $(filter-out $(not_for_tidy),$2) 2>$@.err || { \
		grep -v 'warnings\? generated' $@.err; exit 1; }
	@touch $@
endef

cppcheck: $(GEN)/version.h
	@mkdir -p $(BUILD)/cppcheck
	$(if $(V),,@echo "  CPPCHECK")
	@# What it finds across files does not reach its exit status, so anything it says counts.
	$(Q)said=$$(cppcheck --quiet -j 2 --std=c11 --enable=warning,performance,portability --inline-suppr \
		--suppress=missingIncludeSystem --cppcheck-build-dir=$(BUILD)/cppcheck \
		-D_GNU_SOURCE -Isrc -I. -I$(BUILD) -Itests $(C_SOURCES) $(SHIM_SOURCE) 2>&1); \
		[ -z "$$said" ] || { echo "$$said"; exit 1; }

# ---- Installing -----------------------------------------------------------------------------------------------------

bindir := $(DESTDIR)$(PREFIX)/bin
libdir := $(DESTDIR)$(PREFIX)/lib/roughlight
sharedir := $(DESTDIR)$(PREFIX)/share/roughlight
docdir := $(DESTDIR)$(PREFIX)/share/doc/roughlight

# The tree $1 (where it exists) as $2, plain files, readable by all whatever the umask says.
install_tree = $(if $(wildcard $1),cd $1 && find . -type f -exec install -D -m 644 {} $(abspath $(sharedir))/$2/{} \;)

.PHONY: install uninstall check-install clean setup help
## Install under PREFIX (/usr/local), below DESTDIR
install: all
	install -D -m 755 $(BUILD)/roughlight $(bindir)/roughlight
	install -D -m 755 $(BUILD)/roughlight-oiio.so $(libdir)/roughlight-oiio.so
	$(call install_tree,shaders,shaders)
	$(call install_tree,studies/scenes,scenes)
	$(call install_tree,studies/data,data)
	$(call install_tree,plots,plots)
	install -D -m 644 -t $(sharedir)/tests/hard $(wildcard tests/hard/*.tsv)
	install -D -m 644 -t $(sharedir)/tests/hard/maps $(wildcard tests/hard/maps/*.tsv)
	install -D -m 644 -t $(docdir) $(wildcard README.md) LICENSE

## Remove what install put there
uninstall:
	rm -f $(bindir)/roughlight
	rm -rf $(libdir) $(sharedir) $(docdir)

## Install into a scratch folder, render from there, uninstall; nothing may be missing or left behind
check-install: all
	@scratch=$$(mktemp -d) && trap 'rm -rf "$$scratch"' EXIT && \
	$(MAKE) --no-print-directory install DESTDIR=$$scratch PREFIX=/usr >/dev/null && \
	(cd / && $$scratch/usr/bin/roughlight render $$scratch/usr/share/roughlight/scenes/sphere-quad.yaml \
		--size 64x64 -o $$scratch/image.exr && \
		$$scratch/usr/bin/roughlight study run hard --db $$scratch/db/results.db 2>/dev/null && \
		$$scratch/usr/bin/roughlight hard --backend cpu >/dev/null) && \
	rm -r $$scratch/image.exr $$scratch/db && \
	$(MAKE) --no-print-directory uninstall DESTDIR=$$scratch PREFIX=/usr >/dev/null && \
	left=$$(find $$scratch -type f) && { [ -z "$$left" ] || { echo "left behind: $$left" >&2; exit 1; }; }

## Remove everything that was made
clean:
	rm -rf $(BUILD)

## Install the packages that building, testing and the report need
setup:
	@.ci/setup build test report

## List the targets
help:
	@awk '/^## / { what = substr($$0, 4); next } \
		what != "" && /^[a-z-]+:/ { sub(":.*", ""); printf "  make %-14s %s\n", $$0, what; what = "" }' Makefile
	@sed -n '/^# Variables/,/^$$/ s/^# \{0,1\}//p' Makefile
