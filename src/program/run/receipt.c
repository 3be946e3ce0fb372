/* Writes receipts, and loads scenes by them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/run/run.h"

#include <sha256.h>
#include <stdio.h>
#include <string.h>
#include "input/delimited/delimited.h"
#include "program/io/io.h"

/* A receipt has fewer bytes than that. */
enum { RECEIPT = 1024, HASH = 32 };

static const char first_line[] = "graze receipt 1\n";
static const char solid_key[] = "\nsolid-sha256 ";
static const char checksum_key[] = "\nchecksum ";

static void append_text(char *text, const char *more) {
    strncat(text, more, RECEIPT - strlen(text) - 1);
}

static void append_hex(char *text, const char *key, const unsigned char hash[HASH]) {
    char hex[2 * HASH + 1];
    for (size_t k = 0; k < HASH; k++)
        snprintf(hex + 2 * k, 3, "%02x", hash[k]);
    append_text(text, key);
    append_text(text, hex);
}

/* The checksum is of everything before its line. */
static void append_checksum(char *text) {
    SHA2_CTX sha;
    unsigned char hash[HASH];
    SHA256Init(&sha);
    SHA256Update(&sha, (const uint8_t *)text, strlen(text));
    SHA256Final(hash, &sha);
    append_hex(text, checksum_key, hash);
    append_text(text, "\n");
}

static void make_receipt(char text[RECEIPT], const graze_scene *scene, const scene_options *o) {
    graze_hashes hashes = graze_scene_hashes(scene);
    *text = '\0';
    append_text(text, first_line);
    append_text(text, "version " GRAZE_VERSION);
    append_hex(text, solid_key, hashes.solid);
    append_hex(text, "\nmotion-sha256 ", hashes.motion);
    append_hex(text, "\nscene-sha256 ", hashes.scene);
    append_text(text, o->solid_flags & GRAZE_SOLID_TRIANGULATE ? "\ntriangulate yes"
                                                               : "\ntriangulate no");
    append_text(text, "\nround ");
    append_text(text, graze_rounding_name(o->context.rounding));
    append_checksum(text);
}

int receipt_write(const char *path, const loaded *l, const scene_options *o) {
    char text[RECEIPT];
    make_receipt(text, l->scene, o);
    return output_text(path, text);
}

/* Does the text end with the checksum of what is before it? */
static int is_intact_receipt(const char *text) {
    char again[RECEIPT];
    const char *end = strstr(text, checksum_key);
    if (strncmp(text, first_line, strlen(first_line)) != 0 || !end)
        return 0;
    snprintf(again, sizeof again, "%.*s", (int)(end - text), text);
    append_checksum(again);
    return strcmp(text, again) == 0;
}

static int read_receipt(char text[RECEIPT], const char *path, const context_options *o) {
    size_t length = 0;
    graze_context *context;
    int status = context_make(&context, o);
    if (!status)
        status = complain_of(stream_beginning(text, RECEIPT, &length, context, path), context);
    graze_context_destroy(context);
    if (status)
        return status;
    if (strlen(text) != length || !is_intact_receipt(text))
        return complain(EXIT_INPUT, "%s: expected a receipt as graze check --receipt writes it",
                        path);
    return EXIT_DONE;
}

/* The value of 64 hexadecimal digits behind the key; 0 if there are none. */
static int read_hash_line(unsigned char hash[HASH], const char *text, const char *key) {
    const char *at = strstr(text, key);
    if (!at || strspn(at + strlen(key), "0123456789abcdef") != 2 * HASH)
        return 0;
    for (size_t k = 0; k < HASH; k++) {
        unsigned value;
        if (sscanf(at + strlen(key) + 2 * k, "%2x", &value) != 1)
            return 0;
        hash[k] = (unsigned char)value;
    }
    return 1;
}

static int is_known_before(const char *line) {
    return strncmp(line, "version", 7) == 0 || strncmp(line, "triangulate", 11) == 0 ||
           strncmp(line, "round", 5) == 0;
}

/* Name the line at which a receipt is not that of this run; without a scene only the lines that are
 * known before it is read. */
static int compare_receipts(const char *path, const char *there, const graze_scene *scene,
                            const scene_options *o) {
    char mine[RECEIPT];
    const char *here = mine;
    make_receipt(mine, scene, o);
    while (*there || *here) {
        size_t n = strcspn(there, "\n"), m = strcspn(here, "\n");
        if ((scene || is_known_before(here)) && (n != m || memcmp(there, here, n) != 0))
            return complain(
                EXIT_INPUT,
                "%s: is a receipt for `%.*s`, and this run has `%.*s`; expected a receipt for "
                "this solid, motion and these options",
                path, (int)n, there, (int)m, here);
        there += n + (there[n] == '\n');
        here += m + (here[m] == '\n');
    }
    return EXIT_DONE;
}

int receipt_load(loaded *out, const char *path, const scene_options *o) {
    char text[RECEIPT];
    unsigned char solid[HASH];
    if (!path)
        return loaded_read(out, o, EXIT_INPUT, NULL);
    memset(out, 0, sizeof *out);
    int status = read_receipt(text, path, &o->context);
    if (!status && !read_hash_line(solid, text, solid_key))
        status = complain(EXIT_INPUT, "%s: names no solid", path);
    if (!status)
        status = compare_receipts(path, text, NULL, o);
    if (!status)
        status = loaded_read(out, o, EXIT_INPUT, solid);
    return status ? status : compare_receipts(path, text, out->scene, o);
}
