/* Functions that all kinds of canvas share: paths, texts, and the file, whose extension chooses the
 * kind.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/views.h"

#include <ctype.h>
#include <dlfcn.h>
#include <errno.h>
#include <stdio.h>
#include <unistd.h>
#include "base/context/array.h"
#include "base/context/scope.h"

void drawn_path_clear(drawn_path *p) {
    free(p->node);
    *p = (drawn_path){NULL, 0, 0, 0};
}

void drawn_path_to(drawn_path *p, char verb, double x, double y) {
    if (!p->failed)
        p->failed = !array_reserve(&p->node, &p->capacity, p->count + 1, sizeof *p->node);
    if (!p->failed)
        p->node[p->count++] = (path_node){verb, x, y};
}

void drawn_path_line(drawn_path *p, double x0, double y0, double x1, double y1) {
    drawn_path_to(p, 'M', x0, y0);
    drawn_path_to(p, 'L', x1, y1);
}

void drawn_path_box(drawn_path *p, double x0, double y0, double x1, double y1) {
    drawn_path_line(p, x0, y0, x1, y0);
    drawn_path_to(p, 'L', x1, y1);
    drawn_path_to(p, 'L', x0, y1);
    drawn_path_to(p, 'z', 0, 0);
}

static int append_bytes(void *to, const char *data, size_t length) {
    text *bytes = to;
    text_bytes(bytes, data, length);
    return !bytes->failed;
}

graze_status save_file(graze_context *context, const char *file, const text *bytes) {
    int standard = strncmp(file, "-.", 2) == 0 && !strchr(file, '/');
    const char *name = standard ? "standard output" : file;
    FILE *stream = standard ? fdopen(dup(STDOUT_FILENO), "wb") : fopen(file, "wb");
    if (!stream)
        return context_fail_in(context, GRAZE_ESYSTEM, name, 0, "cannot be opened for writing: %s",
                               strerror(errno));
    int wrong = fwrite(bytes->data, 1, bytes->length, stream) != bytes->length ? errno : 0;
    if (fclose(stream) != 0 && !wrong)
        wrong = errno;
    if (wrong)
        return context_fail_in(context, GRAZE_ESYSTEM, name, 0, "writing failed: %s",
                               strerror(wrong));
    return GRAZE_OK;
}

graze_status canvas_finish(canvas *c, graze_context *context, const char *file,
                           graze_status status) {
    HELD(text, bytes);
    if (!status) {
        c->kind->finish(c, append_bytes, &bytes);
        status = c->failed || bytes.failed
                     ? context_fail(context, GRAZE_ESYSTEM, "out of memory for a picture")
                     : save_file(context, file, &bytes);
    }
    c->kind->destroy(c);
    return status;
}

void canvas_begin(canvas *c, const char *name, const char *attributes) {
    if (c->kind->begin)
        c->kind->begin(c, name, attributes);
}

void canvas_end(canvas *c) {
    if (c->kind->end)
        c->kind->end(c);
}

void canvas_path(canvas *c, drawn_path *p, const style *s, const char *name) {
    c->failed |= p->failed;
    if (p->count)
        c->kind->path(c, p, s, name);
    drawn_path_clear(p);
}

size_t canvas_character(const char *at) {
    const unsigned char *s = (const unsigned char *)at;
    if (*s < 0x80)
        return *s >= 0x20 && *s != 0x7f;
    size_t n = *s >= 0xf0 ? 4 : *s >= 0xe0 ? 3 : 2;
    unsigned long code = *s & (0xffu >> (n + 1));
    if (*s < 0xc2 || *s > 0xf4)
        return 0;
    for (size_t k = 1; k < n; k++) {
        if ((s[k] & 0xc0) != 0x80)
            return 0;
        code = code << 6 | (s[k] & 0x3f);
    }
    int refused = (n == 3 && code < 0x800) || (n == 4 && (code < 0x10000 || code > 0x10ffff)) ||
                  (code >= 0xd800 && code <= 0xdfff) || (code >= 0xfffe && code <= 0xffff) ||
                  (code >= 0x80 && code < 0xa0);
    return refused ? 0 : n;
}

void canvas_text(canvas *c, double x, double y, const lettering *l, const char *string) {
    HELD(text, clean);
    text_put(&clean, "");
    while (*string) {
        size_t n = canvas_character(string);
        text_bytes(&clean, n ? string : "?", n ? n : 1);
        string += n ? n : 1;
    }
    c->failed |= clean.failed;
    if (!clean.failed)
        c->kind->text(c, x, y, l, clean.data);
}

double canvas_text_width(const char *string, double size) {
    double em = 0;
    for (; *string; string++) {
        unsigned char byte = (unsigned char)*string;
        if ((byte & 0xc0) == 0x80)
            continue;
        if (strchr("ijlI.,:;|!'()[]- ", byte))
            em += 0.4;
        else if (strchr("mwMW@%", byte))
            em += 1;
        else
            em += byte < 0x80 ? 0.65 : 0.85;
    }
    return em * size;
}

int file_has_extension(const char *file, const char *extension) {
    const char *dot = strrchr(file, '.');
    if (!dot || strlen(dot + 1) != strlen(extension))
        return 0;
    for (size_t k = 0; extension[k]; k++)
        if (tolower((unsigned char)dot[k + 1]) != extension[k])
            return 0;
    return 1;
}

/* Fontconfig and pixman crash when memory runs out within them. ROOM is more than they and the
 * library's code take; when the image itself does not fit, cairo reports an error. */
enum { ROOM = 64 << 20 };

static graze_status check_room(graze_context *context) {
    void *volatile room = malloc(ROOM); /* volatile keeps malloc and free from being removed */
    if (!room)
        return context_fail(
            context, GRAZE_ESYSTEM,
            "out of memory for a picture: a PNG or PDF takes %d MB; expected more memory, "
            "or an .svg picture",
            ROOM >> 20);
    free(room);
    return GRAZE_OK;
}

/* The shared object stays loaded until the process ends. */
static graze_status load_library(canvas *(**create)(double, double, int), graze_context *context) {
    TRY(check_room(context));
    void *library = dlopen(PNG_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    void *symbol = library ? dlsym(library, "graze_png_create") : NULL;
    if (!symbol)
        return context_fail(context, GRAZE_ESYSTEM,
                            "PNG and PDF pictures need " PNG_LIBRARY
                            ", which cannot be loaded (%s); it is "
                            "built where cairo's headers are (Debian: libcairo2-dev); expected "
                            "that library, or an .svg picture",
                            dlerror());
    /* POSIX: a symbol's address is a function's, which C has no conversion for. */
    memcpy(create, &symbol, sizeof symbol);
    return GRAZE_OK;
}

/* Create a PNG or PDF canvas; if `out` is NULL, only check that the library can be loaded. */
static graze_status create_png(canvas **out, graze_context *context, double width, double height,
                               int pdf) {
    canvas *(*create)(double, double, int) = NULL;
    graze_status status = load_library(&create, context);
    if (status || !out)
        return status;
    *out = create(width, height, pdf);
    return *out ? GRAZE_OK : context_fail(context, GRAZE_ESYSTEM, "out of memory for a picture");
}

graze_status canvas_check(graze_context *context, const char *file) {
    if (file_has_extension(file, "png") || file_has_extension(file, "pdf"))
        return create_png(NULL, context, 0, 0, 0);
    if (file_has_extension(file, "svg"))
        return GRAZE_OK;
    return context_fail(
        context, GRAZE_EUSE,
        "%s: the extension is that of no picture; expected .svg, .png, .pdf or .html", file);
}

graze_status canvas_create(canvas **out, graze_context *context, const char *file, double width,
                           double height) {
    if (file_has_extension(file, "svg"))
        return canvas_create_svg(out, context, width, height);
    return create_png(out, context, width, height, file_has_extension(file, "pdf"));
}
