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
# Where there is no dpkg, libraries are where pkg-config finds them.
ELSEWHERE := $(if $(shell command -v dpkg-query),,$(shell src/install/libraries.sh flags))
COMMON = $(OPT) $(COUNTED) -g $(WARN) -fPIC -fvisibility=hidden -pthread -Iinclude -Isrc $(filter-out -L%,$(ELSEWHERE)) -MMD -MP
ALL_CFLAGS = -std=c11 -D_POSIX_C_SOURCE=200809L $(COMMON) $(GCC_ONLY) $(CFLAGS)
# CGAL's interval arithmetic changes the rounding mode, which the compiler must respect. A unique symbol
# would be shared with a program that uses CGAL too, and CGAL's settings with it.
NOT_UNIQUE := $(if $(findstring clang,$(CXX)),,-fno-gnu-unique)
ALL_CXXFLAGS = -std=c++17 -frounding-math $(NOT_UNIQUE) $(COMMON) $(CXXFLAGS)
# The programs find libgraze-png beside them, in build/, or in ../lib; libgraze.so finds it beside itself.
RPATH = -Wl,-rpath,'$$ORIGIN:$$ORIGIN/$(1)'
VERSION := $(shell sed -n 's/.*define GRAZE_VERSION "\(.*\)"/\1/p' include/graze/version.h)
SONAME := libgraze.so.$(firstword $(subst ., ,$(VERSION)))
LIBS := -lyajl -lmd -lflint -lmpfr -lgmp -lstdc++ -lm -pthread
LIBS += $(filter -L%,$(ELSEWHERE))
ifneq ($(COUNT),)
LIBS += $(COUNT)
endif

# Rooms whose coverage is a gate, with COUNT= the flags by which clang counts what is run; counters elsewhere cost each process time.
COUNTED =
$B/src/decide/%.o $B/src/questions/%.o: COUNTED = $(COUNT)

# Every difference between Debian 12 (CGAL 5.5, FLINT 2.9) and 13 (CGAL 6.0, FLINT 3.1).
DEBIAN := $(firstword $(subst ., ,$(file < /etc/debian_version)))
CLANG  := $(if $(filter 13,$(DEBIAN)),19,14)

# Packages that a bare Debian lacks. Only `make` targets that need a group install it.
PACKAGES_BUILD := g++ libcgal-dev libgmp-dev libmpfr-dev libflint-dev libyajl-dev libmd-dev
PACKAGES_PNG   := libcairo2-dev fonts-dejavu-core
PACKAGES_DEB   := $(PACKAGES_BUILD) dpkg-dev
PACKAGES_DIST  := $(PACKAGES_DEB) git patchelf python3
PACKAGES_TEST  := $(PACKAGES_DEB) $(PACKAGES_PNG) libcmocka-dev python3 python3-numpy pari-gp locales parallel openmpi-bin libopenmpi-dev pkgconf cmake groff-base python3-jsonschema python3-venv python3-gmpy2 python3-yaml mypy python3-pytest python3-hypothesis doctest-dev
PACKAGES_PROOFS := $(PACKAGES_BUILD) coq ocaml-findlib libzarith-ocaml-dev python3
PACKAGES_DOCS  := $(PACKAGES_BUILD) python3 python3-numpy python3-pandas python3-sphinx python3-myst-parser python3-sphinx-copybutton furo doxygen python3-breathe python3-pytest python3-hypothesis
PACKAGES_ALL   := $(PACKAGES_TEST) $(PACKAGES_DOCS) catch2 libgtest-dev python3-shapely python3-meshio chromium clang libclang-rt-$(CLANG)-dev clang-format llvm cppcheck debootstrap reuse patchelf

comma   := ,
LIB_C   := $(wildcard src/api/*.c) $(filter-out src/program/% src/output/png/%,$(wildcard src/*/*/*.c))
LIB_CXX := $(wildcard src/*/*/*.cpp)
LIB_O   := $(LIB_C:%.c=$B/%.o) $(LIB_CXX:%.cpp=$B/%.o)
CLI_O   := $(patsubst %.c,$B/%.o,$(wildcard src/program/cli/*.c src/program/io/*.c src/program/points/*.c src/program/run/*.c))
# graze-mpi is graze classify with ranks that answer rows, built where Open MPI is.
MPI     := $(if $(shell command -v mpicc),$B/graze-mpi)
MPI_O   := $(filter-out %/main.o %/run/jobs.o,$(CLI_O)) $(patsubst %.c,$B/%.o,$(wildcard src/program/mpi/*.c))
# PNG pictures need cairo, which nothing else does: a shared object loaded at need, built where cairo is.
PNG     := $(if $(wildcard /usr/include/cairo/cairo.h),$B/libgraze-png-$(VERSION).so)
UNIT    := $(patsubst tests/%.c,$B/tests/%,$(wildcard tests/unit/*.c tests/api/*.c))
ORACLES := $B/tests/minkowski $B/tests/to_nef $B/tests/distances $B/tests/pairs $B/tests/places
FLIPS   := bounds surfaces filter
FLIP_O  := $(patsubst src/decide/%.c,$B/tests/flip/%.o,$(wildcard $(FLIPS:%=src/decide/%/*.c)))
# Measurements include FCL and Embree where Debian's libfcl-dev and libembree-dev are installed.
FCL     := $(if $(wildcard /usr/include/fcl/fcl.h),$B/tests/bench/fcl)
EMBREE  := $(notdir $(patsubst %/rtcore.h,%,$(lastword $(sort $(wildcard /usr/include/embree?/rtcore.h)))))
BENCH   := $B/tests/bench/inside $B/tests/bench/pairs $B/tests/bench/peers $(FCL) $(EMBREE:%=$B/tests/bench/embree)
# The targets of the fuzzer and the command line they fuzz, without a main.
FUZZ_O  := $(patsubst %.c,$B/%.o,$(filter-out %/entry.c %/replay.c,$(wildcard tests/fuzz/*.c))) $(filter-out %/main.o,$(CLI_O)) $B/tests/fuzz/checker.o
CHECKER_O := $(patsubst src/check/%.c,$B/tests/fuzz/checker/%.o,$(filter-out %/main.c %/ends.c,$(wildcard src/check/*.c))) $B/tests/fuzz/checker/inside.o
REPLAY  := $B/tests/fuzz/replay
# A library in front of a program's main, so that the program starts once a suite; without the sanitizers of the build.
FORKS   := $B/tests/forks.so
# Programs beside those of tests/unit and tests/api that some suites ask.
ASKED   := $(REPLAY) $(FORKS)

.PHONY: all
all: $B/.packages-build $B/graze $B/graze-check $B/libgraze.a $B/libgraze.so $(MPI) $(PNG)

.PHONY: help
help:
	@echo "make            build the program and both libraries under build/"
	@echo "make demo       install what is missing, build, classify the points of cases/bracket"
	@echo "make try        suites of the rooms that have changed since @{upstream} or SINCE=REV (seconds to a minute)"
	@echo "make test       install what is missing, build, run what is derived and a quarter of the random tests (4 minutes on two idle cores)"
	@echo "make cases      check every case under cases/ and recompute it with PARI"
	@echo "make test-long  all in full and more random inputs than CI asks, of SEED=n or the day's, before a release (hours)"
	@echo "make fuzz       every fuzz target for SECONDS=60 (FUZZ_ONLY=\"NAME ...\": some of them)"
	@echo "make coverage   the suites under the sanitizers; line and branch coverage of src/decide, questions, check"
	@echo "make docs       the site, with what its pages show, into build/docs/html/"
	@echo "make pictures   draws figures of the paper from the cases, into build/pictures/"
	@echo "make proofs     check the proofs in proofs/coq by machine, the C functions against them"
	@echo "make graze-check-mini  graze-check on mini-gmp instead of GMP (Debian has its sources)"
	@echo "make checker-page  graze-check as a page of HTML, build/checker-page/graze-check.html (installs emscripten, 0.8 GB)"
	@echo "make bench      speed beside CGAL's, in one run (BENCH_FLAGS=--quick: small counts)"
	@echo "make benchmark  golden rows of 50 scenes into build/benchmark/, against the recorded hashes (a quarter of an hour)"
	@echo "make dataset    the same and the golden cases as files with metadata and checksums, into build/dataset/"
	@echo "make install    under PREFIX=/usr/local, below DESTDIR= if given; make uninstall takes it away"
	@echo "make deb        a Debian package, build/graze_VERSION_ARCHITECTURE.deb"
	@echo "make dist       sources, package, a wheel that carries its libraries, dataset, SHA256SUMS, in build/dist/"
	@echo "make format     clang-format on all sources"
	@echo "make clean      remove build/"
	@echo "V=1 with any of these shows each command"

# ---------------------------------------------------------------- packages
# Install the packages of group $(1) that are missing, and say so. Where there is no dpkg, $(2) looks for them.
define install_packages
	@mkdir -p $(@D); missing=; \
	if ! command -v dpkg-query >/dev/null; then \
	  $(if $(2),$(2),echo "make: no dpkg here; please see to it that these are installed: $(1)"); \
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
	$(call install_packages,$(PACKAGES_BUILD),CC='$(CC)' CXX='$(CXX)' src/install/libraries.sh check || exit 1)
$B/.packages-deb: Makefile | $B/.packages-build
	$(call install_packages,$(PACKAGES_DEB))
$B/.packages-dist: Makefile | $B/.packages-build
	$(call install_packages,$(PACKAGES_DIST))
$B/.packages-emscripten: Makefile | $B/.packages-build
	$(call install_packages,emscripten)
$B/.packages-test: Makefile | $B/.packages-build
	$(call install_packages,$(PACKAGES_TEST))
$B/.packages-pictures: Makefile | $B/.packages-build
	$(call install_packages,$(PACKAGES_PNG))
$B/.packages-proofs: Makefile | $B/.packages-build
	$(call install_packages,$(PACKAGES_PROOFS))
$B/.packages-docs: Makefile | $B/.packages-build
	$(call install_packages,$(PACKAGES_DOCS))
$B/.packages-all: Makefile | $B/.packages-test
	$(call install_packages,$(PACKAGES_ALL))

# ---------------------------------------------------------------- building
# Compilations are counted on one line; `make V=1` shows every command instead.
Q := $(if $(V),,@)
MISSING := $(words $(filter-out $(wildcard $(sort $(LIB_O) $(CLI_O) $(MPI_O))),$(sort $(LIB_O) $(CLI_O) $(if $(MPI),$(MPI_O)))))
$(if $(wildcard $B/.tally),$(shell rm -f $B/.tally))
say = $(if $(V),:,src/install/say.sh $B $(MISSING) $(1) $(2))
$B/%.o: %.c | $B/.packages-build
	@mkdir -p $(@D)
	@$(call say,CC,$<)
	$Q$(CC) $(ALL_CFLAGS) -c -o $@ $<
$B/%.o: %.cpp | $B/.packages-build
	@mkdir -p $(@D)
	@$(call say,CXX,$<)
	$Q$(CXX) $(ALL_CXXFLAGS) -c -o $@ $<
# The library holds the files of a page, and the sentences of explanations.
$B/src/output/report/sentences.o: src/output/report/sentences.json
$(patsubst src/program/cli/help/%.txt,$B/src/program/cli/%.o,$(wildcard src/program/cli/help/*.txt)): $B/src/program/cli/%.o: src/program/cli/help/%.txt
$B/src/program/cli/main.o: src/program/cli/help/overview.txt
$B/src/program/cli/motion.o: src/program/cli/help/motion_examples.txt
$B/src/output/page/assets.o: $(wildcard src/output/page/*.html src/output/page/*.js src/output/page/three/*)
$B/src/program/mpi/%.o: src/program/mpi/%.c | $B/.packages-build
	@mkdir -p $(@D)
	@$(call say,CC,$<)
	$QOMPI_CC="$(CC)" mpicc $(ALL_CFLAGS) -c -o $@ $<
$B/libgraze.a: $(LIB_O)
	@rm -f $@
	@$(call say,AR,$@)
	$Qar rcs $@ $^
$B/libgraze.so: $(LIB_O) src/install/graze.map
	@$(call say,LINK,$@)
	$Q$(CXX) -shared -Wl,-soname,$(SONAME) -Wl,--version-script=src/install/graze.map -Wl,-rpath,'$$ORIGIN' $(OPT) $(LDFLAGS) -o $@ $(LIB_O) $(LIBS)
	$Qln -sf $(@F) $B/$(SONAME)
$B/libgraze-png-$(VERSION).so: $B/src/output/png/png.o
	@$(call say,LINK,$@)
	$Q$(CC) -shared $(OPT) $(LDFLAGS) -o $@ $^ -lcairo
$B/graze: $(CLI_O) $B/libgraze.a
	@$(call say,LINK,$@)
	$Q$(CXX) $(OPT) $(LDFLAGS) $(call RPATH,../lib) -o $@ $^ $(LIBS)
# The checker of certificates stands alone: C11 and GMP, one line.
$B/graze-check: $(wildcard src/check/*.[ch]) | $B/.packages-build
	@$(call say,CC,$@)
	$Q$(CC) -std=c11 $(OPT) -g $(WARN) $(CFLAGS) $(LDFLAGS) -o $@ $(filter %.c,$^) -lgmp -lm
# graze-check without GMP: on mini-gmp, two files of C of GMP's sources, at half the speed.
.PHONY: graze-check-mini
graze-check-mini: $B/graze-check-mini
$B/mini/gmp.h: src/install/mini_gmp.sh src/install/mini_gmp.h.in
	$Qsrc/install/mini_gmp.sh $(@D)
$B/graze-check-mini: $(wildcard src/check/*.[ch]) $B/mini/gmp.h | $B/.packages-build
	@$(call say,CC,$@)
	$Q$(CC) -std=c11 $(OPT) -g -w -include $B/mini/mini-gmp.c -c -o $B/mini/mini-gmp.o $B/mini/mini-mpq.c
	$Q$(CC) -std=c11 $(OPT) -g $(WARN) -I$B/mini $(CFLAGS) $(LDFLAGS) -o $@ $(filter %.c,$^) $B/mini/mini-gmp.o -lm
# graze-check as a page of HTML, for whoever has a browser and nothing else.
.PHONY: checker-page
checker-page: $B/.packages-emscripten $B/checker-page/graze-check.html
$B/checker-page/graze-check.html: $(wildcard src/check/*.[ch]) $B/mini/gmp.h src/install/checker_page.sh src/install/checker_page.html
	@$(call say,EMCC,$@)
	$Qsrc/install/checker_page.sh $B/mini $(@D)
# graze-check with gcc's counts of each branch, beside the plain program, for the suites that ask both.
$B/counted/graze-check: $(wildcard src/check/*.[ch]) | $B/graze
	@mkdir -p $(@D)
	@ln -sfn ../graze $(@D)/graze
	@$(call say,CC,$@)
	$Qgcc -std=c11 -O1 --coverage -g $(WARN) -o $@ $(filter %.c,$^) -lgmp -lm
$B/graze-mpi: $(MPI_O) $B/libgraze.a
	@$(call say,LINK,$@)
	$Q$(CXX) $(OPT) $(LDFLAGS) -o $@ $^ $$(mpicc --showme:link) $(LIBS)
$B/tests/unit/%: $B/tests/unit/%.o $B/libgraze.a
	@$(call say,LINK,$@)
	$Q$(CXX) $(OPT) $(LDFLAGS) $(call RPATH,../..) -o $@ $^ -lcmocka $(LIBS)
$B/tests/api/%: $B/tests/api/%.o $B/libgraze.a
	@$(call say,LINK,$@)
	$Q$(CXX) $(OPT) $(LDFLAGS) $(call RPATH,../..) -o $@ $^ -lcmocka $(LIBS)
$(addsuffix .o,$(UNIT)): | $B/.packages-test
$(FORKS): tests/lib/forks.c | $B/.packages-build
	@mkdir -p $(@D)
	@$(call say,CC,$<)
	$Q$(CC) -std=c11 -O2 $(WARN) -fPIC -shared -o $@ $<
# CGAL's side of the tests: built by suites that ask it anew, as GRAZE_ORACLES says (tests/lib/oracle.py).
$B/tests/minkowski: tests/agree/minkowski.cpp
$B/tests/to_nef: tests/agree/to_nef.cpp
$B/tests/distances: tests/distance/oracle.cpp
$B/tests/pairs: tests/collide/oracle.cpp
$B/tests/places: tests/rest/oracle.cpp
$(ORACLES): tests/agree/shells.h tests/agree/legs.h | $B/.packages-build
	@mkdir -p $(@D)
	@$(call say,CXX,$(filter %.cpp,$^))
	$Q$(CXX) -std=c++17 -O1 -frounding-math -o $@ $(filter %.cpp,$^) -lmpfr -lgmp
$B/tests/bench/inside $B/tests/bench/pairs: $B/tests/bench/%: $B/tests/bench/%.o $B/libgraze.a
	@$(call say,LINK,$@)
	$Q$(CXX) $(OPT) $(LDFLAGS) -o $@ $^ $(LIBS)
# The C functions from a word to a class, with a solid that answers from the word.
$B/tests/proofs/table: $B/tests/proofs/table.o $B/libgraze.a
	@$(call say,LINK,$@)
	$Q$(CXX) $(OPT) $(LDFLAGS) -Wl,--wrap=tracer_locate -o $@ $^ $(LIBS)
# The program with a filter whose decisions can be falsified (src/decide/bounds/bounds.h).
$B/tests/flip/%.o: src/decide/%.c | $B/.packages-build
	@mkdir -p $(@D)
	@$(call say,CC,$<)
	$Q$(CC) $(ALL_CFLAGS) -DGRAZE_FLIP_SITES -c -o $@ $<
$B/tests/graze-flips: $(CLI_O) $(FLIP_O) $(filter-out $(patsubst src/%.c,$B/src/%.o,$(wildcard $(FLIPS:%=src/decide/%/*.c))),$(LIB_O))
	@$(call say,LINK,$@)
	$Q$(CXX) $(OPT) $(LDFLAGS) -o $@ $^ $(LIBS)
# The program whose own allocations fail (tests/memory/fail.c), for sanitizers, who bring a malloc.
$B/tests/memory/fail.o: ALL_CFLAGS += -DWRAPPED -fexceptions
$B/tests/graze-memory: $(CLI_O) $B/tests/memory/fail.o $B/libgraze.a
	@$(call say,LINK,$@)
	$Q$(CXX) $(OPT) $(LDFLAGS) $(addprefix -Wl$(comma)--wrap=,malloc calloc realloc _exit _Znwm _Znam) -o $@ $^ $(LIBS)
# The peers as their users build them: optimised, without assertions.
$B/tests/bench/peers $B/tests/bench/embree: $B/tests/bench/%: tests/bench/%.cpp tests/bench/peer.h | $B/.packages-build
	@mkdir -p $(@D)
	@$(call say,CXX,$<)
	$Q$(CXX) -std=c++17 -O2 -DNDEBUG $(if $(filter peers,$*),-frounding-math) -o $@ $< $(if $(filter peers,$*),-lmpfr -lgmp,-l$(EMBREE))
$B/tests/bench/fcl: cases/candidates/fcl.cpp $B/cases/candidates/scene.o $B/cases/candidates/motion.o
	@mkdir -p $(@D)
	@$(call say,CXX,$<)
	$Q$(CXX) -std=c++17 -O2 -DNDEBUG -isystem /usr/include/eigen3 -o $@ $^ -lfcl -lccd -lyajl -lm
# A locale with a decimal comma, for the tests that must not notice it.
build/tests/locale/de_DE.UTF-8: | $B/.packages-test
	@mkdir -p $(@D)
	localedef -i de_DE -f UTF-8 $@
# graze-check as one object whose names no other's meet; files and memory are taken back by inside.c.
$B/tests/fuzz/checker/%.o: src/check/%.c | $B/.packages-build
	@mkdir -p $(@D)
	@$(CC) $(ALL_CFLAGS) -Dfree=checker_free -Dfopen=checker_fopen -Dfclose=checker_fclose -c -o $@ $<
$B/tests/fuzz/checker.o: $(CHECKER_O)
	@$(call say,LINK,$@)
	$Qld -r -o $@ $^
	$Qobjcopy --keep-global-symbol=checker_run --keep-global-symbol=checker_hash --keep-global-symbol=checker_give $@
$B/tests/fuzz/replay: $B/tests/fuzz/replay.o $(FUZZ_O) $B/libgraze.a
	@$(call say,LINK,$@)
	$Q$(CXX) $(OPT) $(LDFLAGS) -o $@ $^ $(LIBS)
$B/tests/fuzz/fuzz: $B/tests/fuzz/entry.o $(FUZZ_O) $B/libgraze.a
	@$(call say,LINK,$@)
	$Q$(CXX) $(OPT) -fsanitize=fuzzer $(LDFLAGS) -o $@ $^ $(LIBS)
.SECONDARY:

# ---------------------------------------------------------------- installing
PREFIX     ?= /usr/local
BINDIR     ?= $(PREFIX)/bin
INCLUDEDIR ?= $(PREFIX)/include
LIBDIR     ?= $(PREFIX)/lib
DATADIR    ?= $(PREFIX)/share
MANDIR     ?= $(DATADIR)/man
DOCDIR     ?= $(DATADIR)/doc/graze
COMPLETION := $(DATADIR)/bash-completion/completions
CMAKEDIR   := $(LIBDIR)/cmake/graze
# The Python module, where this Python looks under the prefix; it looks for the shared library in the folder that holds
# this one.
PYTHON     ?= $(firstword $(wildcard /usr/bin/python3) python3)
ifeq ($(origin PYTHONDIR),undefined)
PYTHONDIR   = $(or $(shell $(PYTHON) src/install/python_folder.py '$(PREFIX)' 2>/dev/null),$(PREFIX)/lib/python3/dist-packages)
endif
PAGES      := $B/install/pages
TO_INCLUDE  = $(shell realpath -m --relative-to='$(CMAKEDIR)' '$(INCLUDEDIR)')
CMAKE_LIBS := $(subst $() ,;,$(patsubst -l%,%,$(LIBS)))

# In the archive that others link with, all but the public functions is local: an internal function could
# meet one of theirs of the same name.
$B/install/libgraze.a: $(LIB_O)
	@mkdir -p $(@D)
	@rm -f $@
	@$(call say,AR,$@)
	$Q$(CXX) -r -nostdlib -Wl,--force-group-allocation -o $B/install/graze.o $^
	$Qobjcopy --strip-debug --wildcard --keep-global-symbol='graze_*' $B/install/graze.o
	$Qar rcs $@ $B/install/graze.o
# The pages say what --help and the headers say.
$(PAGES): src/program/cli/formats.md $B/graze $B/graze-check include/graze.h $(wildcard include/graze/*.h) $(wildcard src/install/*.awk)
	@$(call say,MAN,$@)
	$Qsrc/install/pages.sh $@.new $B/graze $(VERSION)
	$Qrm -rf $@ && mv $@.new $@
$B/install/%: src/install/%.in FORCE
	@mkdir -p $(@D)
	@sed -e 's|@PREFIX@|$(PREFIX)|; s|@LIBDIR@|$(LIBDIR)|; s|@INCLUDEDIR@|$(INCLUDEDIR)|; s|@VERSION@|$(VERSION)|' \
	  -e 's|@SONAME@|$(SONAME)|; s|@LIBS@|$(LIBS)|; s|@CMAKE_LIBS@|$(CMAKE_LIBS)|; s|@TO_INCLUDE@|$(TO_INCLUDE)|' $< >$@
.PHONY: FORCE
FORCE:

CONFIGURED := $(addprefix $B/install/,graze.pc grazeConfig.cmake grazeConfigVersion.cmake METADATA)
# The module as pip and pytest, which finds its fixtures by it, know what is installed.
DIST_INFO   = $(PYTHONDIR)/graze-$(VERSION).dist-info
# Run ldconfig where the installed library is for this machine at once.
REFRESH = @if [ -z "$(DESTDIR)" ] && [ "$$(id -u)" = 0 ]; then ldconfig; fi

# A path with a blank would be two, and uninstall would remove the first.
define check_paths
	$(if $(filter /%,$(PREFIX)),,$(error PREFIX=$(PREFIX): right is a path that begins with /))
	$(foreach path,DESTDIR PREFIX BINDIR INCLUDEDIR LIBDIR DATADIR MANDIR DOCDIR PYTHONDIR,\
	  $(if $(word 2,$($(path))),$(error $(path)=$($(path)): right is a path without blanks)))
endef

.PHONY: install
install: all $B/install/libgraze.a $(PAGES) $(CONFIGURED)
	$(check_paths)
	@install -d $(addprefix $(DESTDIR),$(BINDIR) $(INCLUDEDIR)/graze $(LIBDIR)/pkgconfig $(CMAKEDIR) \
	  $(MANDIR)/man1 $(MANDIR)/man3 $(MANDIR)/man5 $(COMPLETION) $(DOCDIR) $(DATADIR)/graze $(PYTHONDIR)/graze $(DIST_INFO))
	@install -s $B/graze $B/graze-check $(MPI) $(DESTDIR)$(BINDIR)
	@install -m 644 include/graze.h include/graze.hpp $(DESTDIR)$(INCLUDEDIR)
	@install -m 644 include/graze/*.h include/graze/*.hpp $(DESTDIR)$(INCLUDEDIR)/graze
	@install -m 644 $B/install/libgraze.a $(DESTDIR)$(LIBDIR)
	@install -s -m 644 $B/libgraze.so $(DESTDIR)$(LIBDIR)/libgraze.so.$(VERSION)
	@ln -sf libgraze.so.$(VERSION) $(DESTDIR)$(LIBDIR)/$(SONAME)
	@[ -z "$(PNG)" ] || install -s -m 644 $(PNG) $(DESTDIR)$(LIBDIR)
	@ln -sf $(SONAME) $(DESTDIR)$(LIBDIR)/libgraze.so
	@install -m 644 $B/install/graze.pc $(DESTDIR)$(LIBDIR)/pkgconfig
	@install -m 644 $B/install/*.cmake $(DESTDIR)$(CMAKEDIR)
	@install -m 644 $(PAGES)/*.1 $(DESTDIR)$(MANDIR)/man1
	@install -m 644 $(PAGES)/*.3 $(DESTDIR)$(MANDIR)/man3
	@install -m 644 $(PAGES)/*.5 $(DESTDIR)$(MANDIR)/man5
	@install -m 644 src/output/page/three/LICENSE $(DESTDIR)$(DOCDIR)/LICENSE.three
	@install -m 644 src/program/cli/motion.schema.json src/program/cli/csg.schema.json $(DESTDIR)$(DATADIR)/graze
	@install -m 644 src/install/graze.bash $(DESTDIR)$(COMPLETION)/graze
	@install -m 644 src/python/graze/*.py $(addprefix src/python/graze/,abi.txt py.typed) $(DESTDIR)$(PYTHONDIR)/graze
	@install -m 644 $B/install/METADATA src/install/entry_points.txt $(DESTDIR)$(DIST_INFO)
	@install -m 644 README.md CHANGELOG.md CITATION.cff LICENSE src/program/cli/formats.md proofs/semantics.md proofs/glossary.md $(DESTDIR)$(DOCDIR)
	@rm -rf $(DESTDIR)$(DATADIR)/graze/cases
	@cp -R cases $(DESTDIR)$(DATADIR)/graze
	@find $(DESTDIR)$(DATADIR)/graze -name __pycache__ -prune -exec rm -r {} +
	@chmod -R u=rwX,go=rX $(DESTDIR)$(DATADIR)/graze
	@ls $(PAGES) >$(DESTDIR)$(DATADIR)/graze/pages
	$(REFRESH)
	@echo "graze $(VERSION) is under $(DESTDIR)$(PREFIX)"
	@[ -n "$(DESTDIR)" ] || src/install/environment.sh $(PYTHON) $(PREFIX) $(BINDIR) $(LIBDIR) $(PYTHONDIR)

.PHONY: uninstall
uninstall:
	$(check_paths)
	@rm -f $(addprefix $(DESTDIR),$(BINDIR)/graze $(BINDIR)/graze-check $(BINDIR)/graze-mpi $(INCLUDEDIR)/graze.h $(INCLUDEDIR)/graze.hpp $(LIBDIR)/libgraze.a \
	  $(addprefix $(LIBDIR)/,libgraze.so $(SONAME) libgraze.so.$(VERSION) libgraze-png-$(VERSION).so) $(LIBDIR)/pkgconfig/graze.pc $(COMPLETION)/graze)
	@list=$(DESTDIR)$(DATADIR)/graze/pages; [ ! -f $$list ] || \
	  while read -r page; do rm -f $(DESTDIR)$(MANDIR)/man$${page##*.}/$$page; done <$$list
	@rm -rf $(addprefix $(DESTDIR),$(INCLUDEDIR)/graze $(CMAKEDIR) $(DOCDIR) $(DATADIR)/graze $(PYTHONDIR)/graze $(DIST_INFO))
	$(REFRESH)

.PHONY: deb
deb: $B/.packages-deb all
	+@src/install/deb.sh $B $(VERSION)

# A release: archives of the sources and of the dataset, the package, a wheel that carries its libraries, SHA256SUMS.
.PHONY: dist
dist: $B/.packages-dist dataset
	+@src/install/dist.sh $B $(VERSION)

# ---------------------------------------------------------------- running
.PHONY: demo
demo: all
	@cases/demo.sh $B/graze

.PHONY: test
test: $B/.packages-test all $(UNIT) $(ASKED) build/tests/locale/de_DE.UTF-8
	@$(MAKE) -s B=$B all # Open MPI and cairo are perhaps just installed
	@python3 tests/run.py --build $B $(TEST_FLAGS)

# The suites of the rooms that have changed since @{upstream}, else since the commit of tests/base.txt, or since SINCE=REV.
.PHONY: try
try: $B/.packages-test build/tests/locale/de_DE.UTF-8
	+@python3 tests/changed.py --build $B --programs "$(ASKED)" $(if $(SINCE),--since '$(SINCE)')

# The programs of the tests in another build folder, for the sanitizers.
.PHONY: programs
programs: all $(UNIT) $(REPLAY) $(FORKS) $B/tests/graze-memory build/tests/locale/de_DE.UTF-8

.PHONY: cases
cases: $B/.packages-test all $(FORKS)
	@python3 tests/run.py --build $B --only tests/cases/

# By hand, before a release: all in full, more random inputs than CI asks, of another seed, and CI's suites in other ways.
.PHONY: test-long
test-long: $B/.packages-all test
	@GRAZE_ORACLES=anew python3 tests/stages.py long $(addprefix --seed ,$(SEED))

# The theory, machine-checked: the proofs, the C functions and graze-check against them, and proofs that must fail.
.PHONY: proofs
proofs: $B/.packages-proofs $B/tests/proofs/table $B/graze $B/graze-check
	@python3 tests/proofs/prove.py --build $B
	@python3 tests/proofs/table.py --build $B
	@$(MAKE) -s $B/graze-check-coq
	@python3 tests/proofs/checker.py --build $B
	@python3 tests/proofs/broken.py --build $B $(BROKEN)
# The checker that proofs/coq/extract.v writes, with its reader.
CHECKER_ML := integer.ml checker.mli checker.ml $(addsuffix .ml,fraction text solid motion main)
.PHONY: $B/graze-check-coq
$B/graze-check-coq:
	@mkdir -p $B/checker
	@cp proofs/checker/*.ml $B/proofs/checker.ml $B/proofs/checker.mli $B/checker
	@cd $B/checker && ocamlfind ocamlopt -package zarith,unix -linkpkg $(CHECKER_ML) -o graze-check-coq
	@mv $B/checker/graze-check-coq $@

# Every target for SECONDS, one a core at a time; an input that breaks one is kept in $(FUZZ_BUILD)/found. With FUZZ_PLAIN=1 without
# sanitizers, five to ten times as fast, for many executions.
SECONDS ?= 60
FUZZ_BUILD := build-fuzz$(if $(FUZZ_PLAIN),-plain)
FUZZ_FLAGS := $(if $(FUZZ_PLAIN),-O2 -fsanitize=fuzzer-no-link,-O1 -fsanitize=fuzzer-no-link$(comma)address$(comma)undefined \
              -fno-sanitize-recover=all -fno-omit-frame-pointer)
.PHONY: fuzz
fuzz: $B/.packages-all
	@$(MAKE) -s B=$(FUZZ_BUILD) CC=clang CXX=clang++ OPT="$(FUZZ_FLAGS)" $(FUZZ_BUILD)/tests/fuzz/fuzz $(FUZZ_BUILD)/tests/fuzz/replay
	@python3 tests/fuzz/fuzz.py --build $(FUZZ_BUILD) --seconds $(SECONDS) $(FUZZ_ONLY)

# Lines and branches that the suites under the sanitizers run, by file, of the rooms that decide and that check.
.PHONY: coverage
coverage: $B/.packages-all all
	@tests/stages/sanitizers.sh

.PHONY: bench
bench: all $(BENCH)
	@python3 tests/bench/run.py --graze $B/graze $(BENCH_FLAGS)

# Golden rows of the benchmark, whose hashes are in the tree; the next call continues a run that was ended.
.PHONY: benchmark
benchmark: all
	@python3 cases/benchmark/golden.py --graze $B/graze $B/benchmark

# The benchmark's scenes and the golden cases as files with metadata (SCENES="NAME ...": these alone), continued like them.
.PHONY: dataset
dataset: all
	@python3 cases/dataset/make.py --graze $B/graze --benchmark $B/benchmark $B/dataset $(SCENES)

# The site: what its pages show is run, and each link is followed.
.PHONY: docs
docs: $B/.packages-pictures $B/.packages-docs all
	@$(MAKE) -s B=$B all # cairo is perhaps just installed
	@$(PYTHON) src/docs/build.py --build $B

.PHONY: pictures
pictures: $B/.packages-pictures all
	@cases/pictures.sh $B/graze $B/pictures

.PHONY: lint
lint: $B/.packages-all
	@tests/lint.sh

.PHONY: format
format:
	clang-format -i $$(git ls-files 'include/*.h' 'include/*.hpp' 'src/*.[ch]' 'src/*.[ch]pp' 'tests/*.[ch]' 'tests/*.cpp')

.PHONY: clean
clean:
	rm -rf build build-*

-include $(shell test -d $B && find $B -name '*.d')
