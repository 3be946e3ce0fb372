/* Targets for what a run of classify is continued from and spared by: tables and receipts.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <sha256.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "program/cli/cli.h"
#include "program/cli/values.h"
#include "program/io/io.h"
#include "program/points/points.h"
#include "program/run/run.h"
#include "fuzz.h"

static const char cube_text[] =
    "OFF\n8 6 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n2 2 2\n0 2 2\n"
    "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
static const char move_text[] = "{\"dimension\": 3, \"pieces\": [{\"t\": [0, 1], \"transform\": "
                                "{\"translate\": [\"8*t\", 0, 0]}}]}";
static const char points_text[] = "x,y,z,note\n5,1,1,a\n5,1,2,b\n2,1,1,c\n5,3,1,d\n1/3,1,1,e\n";

/* The scene of the two targets below, as files. */
static void put_scene(char *argv[3]) {
    argv[0] = (char *)fuzz_file("cube.off", (const uint8_t *)cube_text, sizeof cube_text - 1);
    argv[1] = (char *)fuzz_file("move.json", (const uint8_t *)move_text, sizeof move_text - 1);
    argv[2] = (char *)fuzz_file("rows.csv", (const uint8_t *)points_text, sizeof points_text - 1);
}

/* Run classify: 1 if there is a table, 0 if it was refused. */
static int run(char **argv, int argc) {
    int status = command_run(&command_classify, argc, argv);
    EXPECT(status == EXIT_DONE || status == EXIT_INPUT || status == EXIT_LIMIT);
    return status == EXIT_DONE;
}

/* The whole table of that scene, made once. */
static const char *whole_table(char *scene[3]) {
    static char *text;
    if (!text) {
        size_t length;
        char *table = (char *)fuzz_file("table.csv", NULL, 0);
        char *argv[] = {"classify", "--quiet", "--jobs", "1",      "--output",
                        table,      scene[0],  scene[1], scene[2], NULL};
        EXPECT(run(argv, 9));
        text = fuzz_read(table, &length);
    }
    return text;
}

/* The length of a line before its third comma: the point of a row. */
static size_t point_length(const char *line) {
    size_t n = 0;
    for (int commas = 0; line[n] && line[n] != '\n' && commas < 3; n++)
        commas += line[n] == ',';
    return n;
}

/* A table that is continued; a first line `HEAD` stands for the head that this version writes. When
 * the run succeeds, every row is that of the point it should be. */
int fuzz_resume(const uint8_t *data, size_t size) {
    static const char mark[] = "HEAD\n";
    char *scene[3], *start = malloc(size + 4096);
    put_scene(scene);
    EXPECT(start != NULL);
    const char *whole = whole_table(scene), *rows = strstr(whole, "\n5,1,1,");
    size_t head = (size_t)(rows + 1 - whole), used = 0, marked = sizeof mark - 1;
    if (size >= marked && memcmp(data, mark, marked) == 0) {
        memcpy(start, whole, head);
        used = head;
        data += marked;
        size -= marked;
    }
    memcpy(start + used, data, size);
    char *table = (char *)fuzz_file("resumed.csv", (const uint8_t *)start, used + size);
    char *argv[] = {"classify", "--quiet", "--jobs", "1",      "--resume",
                    table,      scene[0],  scene[1], scene[2], NULL};
    int taken = run(argv, 9);
    if (taken) {
        size_t length;
        char *text = fuzz_read(table, &length);
        const char *there = text, *here = whole;
        EXPECT(strlen(text) == length);
        while (*here) {
            size_t n = point_length(here);
            EXPECT(strncmp(there, here, n) == 0);
            here = strchr(here, '\n') + 1;
            there = strchr(there, '\n');
            EXPECT(there != NULL);
            there++;
        }
        EXPECT(*there == '\0');
        free(text);
    }
    free(start);
    return taken;
}

/* The receipt of that scene, without its last line. */
static const char *good_receipt(char *scene[3]) {
    static char *text;
    if (!text) {
        size_t length;
        loaded l;
        scene_options o = {.solid = scene[0], .motion = scene[1]};
        const char *path = fuzz_file("receipt", NULL, 0);
        EXPECT(loaded_read(&l, &o, EXIT_NO, NULL) == EXIT_DONE);
        EXPECT(receipt_write(path, &l, &o) == EXIT_DONE);
        loaded_clear(&l);
        text = fuzz_read(path, &length);
        EXPECT(strstr(text, "\nchecksum ") != NULL);
        *strstr(text, "\nchecksum ") = '\0';
    }
    return text;
}

/* A receipt changed at the places that the bytes name, with a checksum that fits. */
static size_t forge(char *out, const char *good, bytes b) {
    unsigned char hash[32];
    size_t length = strlen(good);
    memcpy(out, good, length);
    while (b.left) {
        size_t at = take(&b) * 256u + take(&b);
        out[at % length] ^= (char)take(&b);
    }
    SHA2_CTX sha;
    SHA256Init(&sha);
    SHA256Update(&sha, (const uint8_t *)out, length);
    SHA256Final(hash, &sha);
    length += (size_t)sprintf(out + length, "\nchecksum ");
    for (int k = 0; k < 32; k++)
        length += (size_t)sprintf(out + length, "%02x", hash[k]);
    out[length++] = '\n';
    return length;
}

/* A receipt as it is, or behind a line `FORGE` places and changes of the good one. Whatever it
 * says, the rows are those of a run without one, or it is refused. */
int fuzz_receipt(const uint8_t *data, size_t size) {
    static const char mark[] = "FORGE\n";
    char *scene[3], forged[4096];
    size_t length = size, marked = sizeof mark - 1;
    put_scene(scene);
    const char *whole = whole_table(scene), *good = good_receipt(scene);
    if (size >= marked && memcmp(data, mark, marked) == 0) {
        length = forge(forged, good, (bytes){data + marked, size - marked});
        data = (const uint8_t *)forged;
    }
    char *receipt = (char *)fuzz_file("receipt", data, length);
    char *table = (char *)fuzz_file("table.csv", NULL, 0);
    char *argv[] = {"classify", "--quiet", "--jobs", "1",      "--receipt", receipt,
                    "--output", table,     scene[0], scene[1], scene[2],    NULL};
    int taken = run(argv, 11);
    if (taken) {
        char *text = fuzz_read(table, &length);
        EXPECT(strcmp(text, whole) == 0);
        free(text);
    }
    return taken;
}
