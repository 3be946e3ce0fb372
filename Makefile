# Graze: exact classification of points against swept solids.   make help lists the targets.
SHELL := /bin/bash
B ?= build
CC ?= gcc
CXX ?= g++
OPT ?= -O2
WARN := -Wall -Wextra -Werror
# -frounding-math: CGAL's interval arithmetic changes the rounding mode.
CFLAGS += -std=c11 -D_POSIX_C_SOURCE=200809L $(OPT) -g $(WARN) -fPIC -fvisibility=hidden -pthread -Iinclude -Isrc -MMD -MP
CXXFLAGS += -std=c++17 $(OPT) -g $(WARN) -fPIC -fvisibility=hidden -frounding-math -pthread -Iinclude -Isrc -MMD -MP
LIBS := -lyajl -lmd -lflint -lmpfr -lgmp -lstdc++ -lm -pthread

LIB_C   := $(filter-out src/cli/%,$(wildcard src/*/*.c src/*.c))
LIB_CXX := $(wildcard src/*/*.cpp)
CLI_C   := $(wildcard src/cli/*.c)
LIB_O   := $(LIB_C:%.c=$B/%.o) $(LIB_CXX:%.cpp=$B/%.o)
CLI_O   := $(CLI_C:%.c=$B/%.o)
UNIT_C  := $(wildcard tests/unit/*.c)
UNIT    := $(UNIT_C:tests/unit/%.c=$B/tests/unit/%)

.PHONY: all
all: $B/graze $B/libgraze.a $B/libgraze.so

$B/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) -c -o $@ $<
$B/%.o: %.cpp
	@mkdir -p $(@D)
	$(CXX) $(CXXFLAGS) -c -o $@ $<
$B/libgraze.a: $(LIB_O)
	@rm -f $@
	ar rcs $@ $^
$B/libgraze.so: $(LIB_O)
	$(CXX) -shared -Wl,-soname,libgraze.so.0 $(LDFLAGS) -o $@ $^ $(LIBS)
$B/graze: $(CLI_O) $B/libgraze.a
	$(CXX) $(LDFLAGS) -o $@ $^ $(LIBS)
$B/tests/unit/%: $B/tests/unit/%.o $B/libgraze.a
	$(CXX) $(LDFLAGS) -o $@ $^ -lcmocka $(LIBS)

-include $(shell find $B -name '*.d' 2>/dev/null)
