# Graze: exact classification of points against swept solids.  `make help` lists the targets.
SHELL := /bin/bash
ifeq ($(filter -j%,$(MAKEFLAGS)),)
MAKEFLAGS += -j$(shell nproc)
endif
B ?= build
ifeq ($(origin CC),default)
CC := gcc
endif
ifeq ($(origin CXX),default)
CXX := g++
endif
OPT ?= -O2
# FLINT 2.9 takes a field of its fmpq for an array of the whole, at which gcc 12 stumbles.
GCC_ONLY := $(if $(findstring clang,$(CC)),,-Wno-stringop-overread -Wno-stringop-overflow)
WARN := -Wall -Wextra -Werror
COMMON = $(OPT) -g $(WARN) -fPIC -fvisibility=hidden -pthread -Iinclude -Isrc -MMD -MP
ALL_CFLAGS = -std=c11 -D_POSIX_C_SOURCE=200809L $(COMMON) $(GCC_ONLY) $(CFLAGS)
# CGAL's interval arithmetic changes the rounding mode, which the compiler must respect.
ALL_CXXFLAGS = -std=c++17 -frounding-math $(COMMON) $(CXXFLAGS)
LIBS := -lyajl -lmd -lflint -lmpfr -lgmp -lstdc++ -lm -pthread

# What a bare Debian 12 lacks. Only `make` targets that need a group install it.
PACKAGES_BUILD := g++ libcgal-dev libgmp-dev libmpfr-dev libflint-dev libyajl-dev libmd-dev
PACKAGES_PNG   := libcairo2 fonts-dejavu-core
PACKAGES_TEST  := $(PACKAGES_BUILD) $(PACKAGES_PNG) libcmocka-dev python3 pari-gp locales
PACKAGES_ALL   := $(PACKAGES_TEST) clang libclang-rt-14-dev clang-format cppcheck

LIB_C   := $(wildcard src/*.c) $(filter-out src/cli/%,$(wildcard src/*/*.c))
LIB_CXX := $(wildcard src/*/*.cpp)
LIB_O   := $(LIB_C:%.c=$B/%.o) $(LIB_CXX:%.cpp=$B/%.o)
CLI_O   := $(patsubst %.c,$B/%.o,$(wildcard src/cli/*.c))
UNIT    := $(patsubst tests/%.c,$B/tests/%,$(wildcard tests/unit/*.c tests/api/*.c))
ORACLES := $B/tests/minkowski $B/tests/to_nef
BENCH   := $B/tests/bench/inside $B/tests/bench/peers

.PHONY: all
all: $B/.packages-build $B/graze $B/libgraze.a $B/libgraze.so

.PHONY: help
help:
	@echo "make            build the program and both libraries under build/"
	@echo "make demo       install what is missing, build, classify the points of cases/bracket"
	@echo "make test       install what is missing, build, run every test (a few minutes)"
	@echo "make cases      check every case under cases/ and recompute it with PARI"
	@echo "make test-all   the long tests, sanitizers, mutants and lint (under an hour)"
	@echo "make pictures   draws figures of the paper from the cases, into build/pictures/"
	@echo "make bench      speed beside CGAL's, in one run (BENCH_FLAGS=--quick: small counts)"
	@echo "make format     clang-format on all sources"
	@echo "make clean      remove build/"

# ---------------------------------------------------------------- packages
# Install the packages of group $(1) that are missing, and say so.
define install_packages
	@mkdir -p $(@D); missing=; \
	if ! command -v dpkg-query >/dev/null; then \
	  echo "make: no dpkg here; please see to it that these are installed: $(1)"; \
	else \
	  for p in $(1); do dpkg-query -W -f='$${Status}' $$p 2>/dev/null | grep -q ' installed' \
	    || missing="$$missing $$p"; done; \
	  if [ -n "$$missing" ]; then \
	    echo "make: installing Debian packages:$$missing"; \
	    if [ "$$(id -u)" = 0 ]; then as=; \
	    elif command -v sudo >/dev/null; then as=sudo; \
	    else echo "make: neither root nor sudo is here; please have these installed:$$missing" >&2; exit 1; fi; \
	    export DEBIAN_FRONTEND=noninteractive; \
	    $$as apt-get update -qq && $$as apt-get install -y -qq --no-install-recommends $$missing \
	      >$B/packages.log 2>&1 \
	      || { cat $B/packages.log >&2; echo "make: apt-get could not install:$$missing" >&2; exit 1; }; \
	  fi; \
	fi; touch $@
endef
$B/.packages-build: Makefile
	$(call install_packages,$(PACKAGES_BUILD))
$B/.packages-test: Makefile | $B/.packages-build
	$(call install_packages,$(PACKAGES_TEST))
$B/.packages-pictures: Makefile | $B/.packages-build
	$(call install_packages,$(PACKAGES_PNG))
$B/.packages-all: Makefile | $B/.packages-test
	$(call install_packages,$(PACKAGES_ALL))

# ---------------------------------------------------------------- building
$B/%.o: %.c | $B/.packages-build
	@mkdir -p $(@D)
	@echo "  CC   $<"
	@$(CC) $(ALL_CFLAGS) -c -o $@ $<
$B/%.o: %.cpp | $B/.packages-build
	@mkdir -p $(@D)
	@echo "  CXX  $<"
	@$(CXX) $(ALL_CXXFLAGS) -c -o $@ $<
$B/libgraze.a: $(LIB_O)
	@rm -f $@
	@echo "  AR   $@"
	@ar rcs $@ $^
$B/libgraze.so: $(LIB_O)
	@echo "  LINK $@"
	@$(CXX) -shared -Wl,-soname,libgraze.so.0 $(OPT) $(LDFLAGS) -o $@ $^ $(LIBS)
	@ln -sf $(@F) $@.0
$B/graze: $(CLI_O) $B/libgraze.a
	@echo "  LINK $@"
	@$(CXX) $(OPT) $(LDFLAGS) -o $@ $^ $(LIBS)
$B/tests/unit/%: $B/tests/unit/%.o $B/libgraze.a
	@echo "  LINK $@"
	@$(CXX) $(OPT) $(LDFLAGS) -o $@ $^ -lcmocka $(LIBS)
$B/tests/api/%: $B/tests/api/%.o $B/libgraze.a
	@echo "  LINK $@"
	@$(CXX) $(OPT) $(LDFLAGS) -o $@ $^ -lcmocka $(LIBS)
$(addsuffix .o,$(UNIT)): | $B/.packages-test
$B/tests/minkowski: tests/agree/minkowski.cpp tests/agree/shells.h | $B/.packages-build
	@mkdir -p $(@D)
	@echo "  CXX  $<"
	@$(CXX) -std=c++17 -O1 -frounding-math -o $@ $< -lmpfr -lgmp
$B/tests/to_nef: tests/agree/to_nef.cpp tests/agree/shells.h | $B/.packages-build
	@mkdir -p $(@D)
	@echo "  CXX  $<"
	@$(CXX) -std=c++17 -O1 -frounding-math -o $@ $< -lmpfr -lgmp
$B/tests/bench/inside: $B/tests/bench/inside.o $B/libgraze.a
	@echo "  LINK $@"
	@$(CXX) $(OPT) $(LDFLAGS) -o $@ $^ $(LIBS)
# The peers as their users build them: optimised, without assertions.
$B/tests/bench/peers: tests/bench/peers.cpp | $B/.packages-build
	@mkdir -p $(@D)
	@echo "  CXX  $<"
	@$(CXX) -std=c++17 -O2 -DNDEBUG -frounding-math -o $@ $< -lmpfr -lgmp
# A locale with a decimal comma, for the tests that must not notice it.
build/tests/locale/de_DE.UTF-8: | $B/.packages-test
	@mkdir -p $(@D)
	localedef -i de_DE -f UTF-8 $@
.SECONDARY:

# ---------------------------------------------------------------- running
.PHONY: demo
demo: all
	@cases/demo.sh $B/graze

.PHONY: test
test: $B/.packages-test all $(UNIT) $(ORACLES) build/tests/locale/de_DE.UTF-8
	@python3 tests/run.py --build $B

# The programs of the tests in another build folder, for the sanitizers.
.PHONY: programs
programs: all $(UNIT) build/tests/locale/de_DE.UTF-8

.PHONY: cases
cases: $B/.packages-test all
	@python3 tests/run.py --build $B --only tests/cases/

.PHONY: test-all
test-all: $B/.packages-all test
	@tests/long.sh

.PHONY: bench
bench: all $(BENCH)
	@python3 tests/bench/run.py --graze $B/graze $(BENCH_FLAGS)

.PHONY: pictures
pictures: $B/.packages-pictures all
	@cases/pictures.sh $B/graze $B/pictures

.PHONY: lint
lint: $B/.packages-all
	@tests/lint.sh

.PHONY: format
format:
	clang-format -i $$(git ls-files 'include/*.h' 'src/*.[ch]' 'src/*.[ch]pp' 'tests/*.[ch]' 'tests/*.cpp')

.PHONY: clean
clean:
	rm -rf build build-*

-include $(shell test -d $B && find $B -name '*.d')
