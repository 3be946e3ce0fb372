/* graze-check as a function: its ends come back, and what it has taken is given back.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Stands in for src/check/ends.c and main.c. Linked with the other files of src/check into one
 * object that shows `checker_run` alone (Makefile), since Graze has names like theirs.
 */
#include <setjmp.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../src/check/check.h"

int checker_run(const char *const path[4], int assume_legal);
void checker_give(const char *const path[4], char *const text[4]);
void checker_hash(char out[65], const char *bytes, size_t length);

/* The files are compiled with these for free, fopen and fclose. */
void checker_free(void *data);
FILE *checker_fopen(const char *path, const char *mode);
int checker_fclose(FILE *file);

enum { MOST_FILES = 8 };

/* All blocks, a list; memory of GMP too. */
typedef struct block {
    struct block *next, *before;
    size_t size;
    max_align_t data[];
} block;

static block first = {&first, &first, 0};
static FILE *open_files[MOST_FILES];
/* Files that are texts in memory; a path or NULL. */
static struct { const char *path, *text; } given[4];
static jmp_buf back;

static void *take(size_t size) {
    block *b = size < SIZE_MAX / 2 ? malloc(sizeof *b + size) : NULL;
    if (!b)
        longjmp(back, NOT_CHECKED);
    *b = (block){first.next, &first, size};
    b->next->before = b;
    first.next = b;
    return b->data;
}

static void give_back(void *data, size_t size) {
    (void)size;
    block *b = (block *)((char *)data - offsetof(block, data));
    b->before->next = b->next;
    b->next->before = b->before;
    free(b);
}

static void *change(void *data, size_t old_size, size_t size) {
    (void)old_size;
    block *b = (block *)((char *)data - offsetof(block, data));
    void *out = take(size);
    memcpy(out, data, b->size < size ? b->size : size);
    give_back(data, 0);
    return out;
}

void checker_free(void *data) {
    if (data)
        give_back(data, 0);
}

void checker_give(const char *const path[4], char *const text[4]) {
    for (int k = 0; k < 4; k++) {
        given[k].path = path[k];
        given[k].text = text[k];
    }
}

static FILE *open_given(const char *path, const char *mode) {
    for (int k = 0; k < 4; k++)
        if (given[k].path == path)
            return *given[k].text ? fmemopen((void *)given[k].text, strlen(given[k].text), mode)
                                  : fopen("/dev/null", mode);
    return fopen(path, mode);
}

FILE *checker_fopen(const char *path, const char *mode) {
    FILE *file = open_given(path, mode);
    for (int k = 0; k < MOST_FILES && file; k++)
        if (!open_files[k]) {
            open_files[k] = file;
            return file;
        }
    return file;
}

int checker_fclose(FILE *file) {
    for (int k = 0; k < MOST_FILES; k++)
        if (open_files[k] == file)
            open_files[k] = NULL;
    return fclose(file);
}

void end_with(int status, const char *format, ...) {
    (void)format;
    longjmp(back, status);
}

void *grow(void *old, size_t count, size_t size) {
    if (count > SIZE_MAX / 2 / size)
        give_up("out of memory");
    size_t bytes = count ? count * size : 1;
    return old ? change(old, 0, bytes) : take(bytes);
}

/* The status that graze-check would end with. */
int checker_run(const char *const path[4], int assume_legal) {
    task work = {{path[0], path[1], path[2], path[3]}, assume_legal, 1};
    mp_set_memory_functions(take, change, give_back);
    int status = setjmp(back);
    if (status == 0)
        (void)check_files(&work);
    while (first.next != &first)
        give_back(first.next->data, 0);
    for (int k = 0; k < MOST_FILES; k++)
        if (open_files[k])
            checker_fclose(open_files[k]);
    return status;
}

void checker_hash(char out[65], const char *bytes, size_t length) {
    mp_set_memory_functions(take, change, give_back);
    sha256_text(out, bytes, length);
}
