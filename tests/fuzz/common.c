/* Contexts, files, sections and words for the targets (fuzz.h).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "fuzz.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <yajl/yajl_parse.h>

/* The order is that of the enumeration; the words are for the command line. */
static const struct {
    unsigned long value;
    const char *word;
} limits[GRAZE_LIMIT_COUNT] = {
    [GRAZE_LIMIT_DIGITS] = {60, "digits=60"}, [GRAZE_LIMIT_DEGREE] = {10, "degree=10"},
    [GRAZE_LIMIT_PIECES] = {40, "pieces=40"}, [GRAZE_LIMIT_DEPTH] = {20, "depth=20"},
    [GRAZE_LIMIT_GRID] = {500, "grid=500"},   [GRAZE_LIMIT_LINE] = {2000, "line=2000"},
    [GRAZE_LIMIT_CELLS] = {300, "cells=300"}, [GRAZE_LIMIT_BYTES] = {50000, "bytes=50000"},
    [GRAZE_LIMIT_BITS] = {2000, "bits=2000"}, [GRAZE_LIMIT_WORK] = {300000, "work=300000"},
    [GRAZE_LIMIT_CURVE] = {4, "curve=4"},     [GRAZE_LIMIT_ARCS] = {1000, "arcs=1000"},
};

void fuzz_broken(const char *promise, const char *file, int line) {
    char text[300];
    int length = snprintf(text, sizeof text, "%s:%d: broken: %s\n", file, line, promise);
    /* The descriptor is written, as the stream may be closed. */
    if (write(STDERR_FILENO, text, (size_t)length) < 0 ||
        write(STDOUT_FILENO, text, (size_t)length) < 0)
        abort();
    abort();
}

/* One line, not empty, without control characters. */
static int is_message(const char *text) {
    for (const char *at = text; *at; at++)
        if ((unsigned char)*at < ' ' || *at == 127)
            return 0;
    return *text != '\0';
}

int fuzz_taken(graze_status status, const graze_context *context, const void *out) {
    if (status == GRAZE_OK) {
        EXPECT(out != NULL);
        return 1;
    }
    EXPECT(status == GRAZE_EINPUT || status == GRAZE_EILLEGAL || status == GRAZE_ELIMIT);
    EXPECT(out == NULL);
    EXPECT(is_message(graze_context_message(context)));
    return 0;
}

int fuzz_is_json(const char *text, size_t length) {
    yajl_handle parser = yajl_alloc(NULL, NULL, NULL);
    EXPECT(parser != NULL);
    int good = yajl_parse(parser, (const unsigned char *)text, length) == yajl_status_ok &&
               yajl_complete_parse(parser) == yajl_status_ok;
    yajl_free(parser);
    return good;
}

void fuzz_limit(graze_context *context) {
    for (int k = 0; k < GRAZE_LIMIT_COUNT; k++)
        if (limits[k].value) {
            EXPECT(graze_context_set_limit(context, (graze_limit)k, limits[k].value) == GRAZE_OK);
            EXPECT(graze_context_limit(context, (graze_limit)k) == limits[k].value);
        }
}

graze_context *fuzz_context(void) {
    graze_context *context;
    EXPECT(graze_context_create(&context) == GRAZE_OK);
    fuzz_limit(context);
    return context;
}

const char *const *fuzz_limit_words(int *count) {
    static const char *out[2 * GRAZE_LIMIT_COUNT];
    *count = 0;
    for (int k = 0; k < GRAZE_LIMIT_COUNT; k++)
        if (limits[k].word) {
            out[(*count)++] = "--limit";
            out[(*count)++] = limits[k].word;
        }
    return out;
}

/* This process's folder, below GRAZE_FUZZ_FOLDER or /tmp, removed at the end if it comes to one. */
static char folder[200];

static void remove_folder(void) {
    char command[240];
    snprintf(command, sizeof command, "rm -rf '%s'", folder);
    if (system(command) != 0)
        perror(folder);
}

const char *fuzz_file(const char *name, const uint8_t *data, size_t size) {
    static char paths[8][256];
    static unsigned next;
    if (!*folder) {
        const char *above = getenv("GRAZE_FUZZ_FOLDER");
        snprintf(folder, sizeof folder, "%s/graze-fuzz-XXXXXX", above ? above : "/tmp");
        EXPECT(mkdtemp(folder) != NULL);
        atexit(remove_folder);
    }
    char *path = paths[next++ % 8];
    snprintf(path, sizeof *paths, "%s/%s", folder, name);
    int fd = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    EXPECT(fd >= 0);
    EXPECT(write(fd, data, size) == (ssize_t)size);
    close(fd);
    return path;
}

char *fuzz_read(const char *path, size_t *size) {
    FILE *file = fopen(path, "rb");
    struct stat about;
    EXPECT(file != NULL && fstat(fileno(file), &about) == 0);
    *size = (size_t)about.st_size;
    char *out = malloc(*size + 1);
    EXPECT(out != NULL && fread(out, 1, *size, file) == *size);
    out[*size] = '\0';
    fclose(file);
    return out;
}

void fuzz_sections(section *out, int count, const uint8_t *data, size_t size) {
    static const char mark[] = "----\n";
    size_t length = sizeof mark - 1;
    for (int k = 0; k < count; k++) {
        size_t n = 0;
        int found = 0;
        for (; n + length <= size && k + 1 < count; n++)
            if ((n == 0 || data[n - 1] == '\n') && memcmp(data + n, mark, length) == 0) {
                found = 1;
                break;
            }
        out[k] = (section){data, found ? n : size};
        size_t used = found ? n + length : size;
        data += used;
        size -= used;
    }
}

char *fuzz_text(section s) {
    char *out = malloc(s.size + 1);
    EXPECT(out != NULL);
    memcpy(out, s.data, s.size);
    out[s.size] = '\0';
    return out;
}

/* Words after which a command would write or read a file that is not this process's own: of options
 * any abbreviation. */
static int names_file(const char *word) {
    static const char *const files[] = {"--output",    "--report", "--resume", "--receipt",
                                        "--folder",    "--keep",   "--points", "--solid",
                                        "--candidate", "--motion"};
    if (strncmp(word, "-o", 2) == 0 || strncmp(word, "-p", 2) == 0 || strcmp(word, "poses") == 0 ||
        strcmp(word, "gcode") == 0 || strcmp(word, "--") == 0)
        return 1;
    for (size_t k = 0; k < sizeof files / sizeof *files && word[0] == '-' && word[1] == '-'; k++) {
        size_t n = strcspn(word, "=");
        if (n > 2 && strncmp(word, files[k], n) == 0)
            return 1;
    }
    return 0;
}

void fuzz_words(words *out, const char *name, section s) {
    /* The program reads its options once; getopt keeps a place in the words of the last time. */
    char *none[] = {(char *)name, NULL};
    optind = 0;
    EXPECT(getopt(1, none, "-") == -1);
    out->text = fuzz_text(s);
    out->count = 0;
    out->word[out->count++] = (char *)name;
    for (char *at = strtok(out->text, "\n"); at && out->count < FUZZ_WORDS; at = strtok(NULL, "\n"))
        if (!names_file(at))
            out->word[out->count++] = at;
    out->word[out->count] = NULL;
}

unsigned take(bytes *b) {
    if (b->left == 0)
        return 0;
    b->left--;
    return *b->at++;
}

int take_from(bytes *b, int low, int high) {
    return low + (int)(take(b) % (unsigned)(high - low + 1));
}

void take_rational(mpq_t out, bytes *b) {
    int value = take_from(b, -64, 191);
    /* Most are small and even: contacts want whole numbers. */
    if (value > 64)
        mpq_set_si(out, value % 9 - 4, 1 + (unsigned long)(value % 2));
    else
        mpq_set_si(out, value, 1 + (unsigned long)take_from(b, 0, 6));
    mpq_canonicalize(out);
}
