/* Writes receipts, and loads scenes by them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/run/run.h"

#include <sha256.h>
#include <stdio.h>
#include "base/context/scope.h"

/* A receipt has fewer than RECEIPT bytes; a hash has HASH bytes. */
enum { RECEIPT = 1024, HASH = 32 };

static const char first_line[] = "graze receipt 1\n";
static const char solid_key[] = "\nsolid-sha256 ";
static const char checksum_key[] = "\nchecksum ";

static void put_hash_line(text *t, const char *key, const unsigned char hash[HASH]) {
    text_put(t, key);
    for (size_t k = 0; k < HASH; k++)
        text_format(t, "%02x", hash[k]);
}

/* Append the line with the checksum of all lines before it. */
static void put_checksum(text *t) {
    char hex[SHA256_DIGEST_STRING_LENGTH];
    SHA256Data((const uint8_t *)t->data, t->length, hex);
    text_format(t, "%s%s\n", checksum_key, hex);
}

static void put_receipt(text *t, const graze_scene *scene, const scene_options *o) {
    graze_hashes hashes = graze_scene_hashes(scene);
    text_format(t, "%sversion " GRAZE_VERSION, first_line);
    put_hash_line(t, solid_key, hashes.solid);
    put_hash_line(t, "\nmotion-sha256 ", hashes.motion);
    put_hash_line(t, "\nscene-sha256 ", hashes.scene);
    text_format(t, "\ntriangulate %s\nround %s",
                o->solid_flags & GRAZE_SOLID_TRIANGULATE ? "yes" : "no",
                graze_rounding_name(o->context.rounding));
    if (!t->failed)
        put_checksum(t);
}

int receipt_write(const char *path, const loaded *l, const scene_options *o) {
    HELD(text, t);
    put_receipt(&t, l->scene, o);
    return t.failed ? complain(EXIT_IO, "out of memory") : output_text(path, t.data);
}

/* Does a receipt end with the checksum of the lines before it? -1: out of memory. */
static int is_intact_receipt(const char *receipt) {
    HELD(text, again);
    const char *end = strstr(receipt, checksum_key);
    if (strncmp(receipt, first_line, strlen(first_line)) != 0 || !end)
        return 0;
    text_bytes(&again, receipt, (size_t)(end - receipt));
    if (!again.failed)
        put_checksum(&again);
    return again.failed ? -1 : strcmp(receipt, again.data) == 0;
}

static int read_receipt(char text[RECEIPT], const char *path, const context_options *o) {
    size_t length = 0;
    OWNED(graze_context, context);
    TRY(context_make(&context, o));
    TRY(complain_of(stream_beginning(text, RECEIPT, &length, context, path), context));
    int is_intact = strlen(text) == length ? is_intact_receipt(text) : 0;
    if (is_intact < 0)
        return complain(EXIT_IO, "out of memory");
    if (!is_intact)
        return complain(EXIT_INPUT, "%s: expected a receipt as graze check --receipt writes it",
                        path);
    return EXIT_DONE;
}

/* Read the hash of 64 hexadecimal digits behind a key; 0 if there is none. */
static int read_hash_line(unsigned char hash[HASH], const char *text, const char *key) {
    const char *at = strstr(text, key);
    if (!at || strspn(at + strlen(key), "0123456789abcdef") != 2 * HASH)
        return 0;
    for (size_t k = 0; k < HASH; k++)
        sscanf(at + strlen(key) + 2 * k, "%2hhx", &hash[k]);
    return 1;
}

static int is_known_before(const char *line) {
    return strncmp(line, "version", 7) == 0 || strncmp(line, "triangulate", 11) == 0 ||
           strncmp(line, "round", 5) == 0;
}

/* Refuse a receipt that differs from this run's, and name the first line that differs. If `scene`
 * is NULL, only the lines are compared that are known before a scene is read. */
static int compare_receipts(const char *path, const char *there, const graze_scene *scene,
                            const scene_options *o) {
    HELD(text, mine);
    field a, b;
    put_receipt(&mine, scene, o);
    if (mine.failed)
        return complain(EXIT_IO, "out of memory");
    for (const char *here = mine.data; lines_differ(&a, &b, &there, &here);)
        if (scene || is_known_before(b.start))
            return complain(
                EXIT_INPUT,
                "%s: is a receipt for `%.*s`, and this run has `%.*s`; expected a receipt for "
                "this solid, motion and these options",
                path, (int)a.length, a.start, (int)b.length, b.start);
    return EXIT_DONE;
}

int receipt_load(loaded *out, const char *path, const scene_options *o) {
    char receipt[RECEIPT];
    unsigned char solid[HASH];
    if (!path)
        return loaded_read(out, o, EXIT_INPUT, NULL);
    memset(out, 0, sizeof *out);
    TRY(read_receipt(receipt, path, &o->context));
    if (!read_hash_line(solid, receipt, solid_key))
        return complain(EXIT_INPUT, "%s: names no solid", path);
    TRY(compare_receipts(path, receipt, NULL, o));
    TRY(loaded_read(out, o, EXIT_INPUT, solid));
    return compare_receipts(path, receipt, out->scene, o);
}
