/* Reads the nodes of OpenSCAD's `.csg` files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * NAME(ARGUMENTS); or NAME(ARGUMENTS) {NODES}, with a mark before the name. Invariant while
 * reading: `open` is the innermost node whose brace is not closed, `depth` the number of such
 * nodes.
 */
#include <ctype.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "input/scad/arguments.h"

typedef struct scan {
    graze_context *context;
    scad *file;
    const char *text;
    size_t length, at, line, open, depth;
} scan;

static const struct {
    const char *name;
    scad_role role;
} roles[] = {{"union", SCAD_UNION},
             {"group", SCAD_UNION},
             {"color", SCAD_UNION},
             {"render", SCAD_UNION},
             {"difference", SCAD_DIFFERENCE},
             {"intersection", SCAD_INTERSECTION},
             {"multmatrix", SCAD_MAP},
             {"linear_extrude", SCAD_EXTRUSION},
             {"rotate_extrude", SCAD_REVOLUTION},
             {"hull", SCAD_HULL},
             {"minkowski", SCAD_MINKOWSKI},
             {"offset", SCAD_OFFSET},
             {"cube", SCAD_CUBE},
             {"sphere", SCAD_SPHERE},
             {"cylinder", SCAD_CYLINDER},
             {"polyhedron", SCAD_POLYHEDRON},
             {"square", SCAD_SQUARE},
             {"circle", SCAD_CIRCLE},
             {"polygon", SCAD_POLYGON}};

static graze_status fail_here(scan *s, const char *what) {
    return context_fail_in(s->context, GRAZE_EINPUT, s->file->source, s->line, "%s", what);
}

static graze_status limit_here(scan *s, graze_limit limit, const char *what) {
    return context_in(s->context, context_limit(s->context, limit, what), s->file->source, s->line);
}

/* Go to the last byte of a comment that begins here; 0 if none does, or if it does not end. */
static int skip_comment(scan *s) {
    const char *text = s->text + s->at, *end = s->text + s->length;
    if (end - text < 2 || text[0] != '/' || (text[1] != '/' && text[1] != '*'))
        return 0;
    size_t at = s->at + 2, lines = 0;
    for (; at < s->length; at++) {
        lines += s->text[at] == '\n';
        if (text[1] == '/' ? s->text[at] == '\n'
                           : s->text[at] == '/' && s->text[at - 1] == '*' && at > s->at + 2)
            break;
    }
    if (at == s->length && text[1] == '*')
        return 0;
    s->line += lines;
    s->at = at < s->length ? at : at - 1;
    return 1;
}

/* Go to the next byte that is no blank; 0 at the end of the text, and at a NUL byte. */
static char next_byte(scan *s) {
    for (; s->at < s->length; s->at++) {
        if (isspace((unsigned char)s->text[s->at]))
            s->line += s->text[s->at] == '\n';
        else if (!skip_comment(s))
            break;
    }
    return s->at < s->length ? s->text[s->at] : 0;
}

static field scan_name(scan *s) {
    field name = {s->text + s->at, 0};
    for (; s->at < s->length; s->at++, name.length++)
        if (!isalnum((unsigned char)s->text[s->at]) && s->text[s->at] != '_')
            break;
    return name;
}

/* Scan arguments in parentheses; the opening one has been read. */
static graze_status scan_arguments(field *out, scan *s) {
    size_t start = s->at, line = s->line, round = 1;
    int quoted = 0;
    for (; s->at < s->length && round > 0; s->at++) {
        char c = s->text[s->at];
        s->line += c == '\n';
        if (quoted && c == '\\')
            s->at++;
        else if (c == '"')
            quoted = !quoted;
        else if (!quoted)
            round = c == '(' ? round + 1 : c == ')' ? round - 1 : round;
    }
    if (round > 0) {
        s->line = line;
        return fail_here(s, "the file ends within the parentheses that begin here");
    }
    *out = (field){s->text + start, s->at - 1 - start};
    return GRAZE_OK;
}

/* Append a node as the last child of the open one. */
static graze_status add_node(scan *s, const scad_node *made) {
    scad *file = s->file;
    if (file->count >= s->context->limits[GRAZE_LIMIT_CELLS])
        return limit_here(s, GRAZE_LIMIT_CELLS, "nodes of a solid");
    TRY(array_grow(s->context, &file->node, &file->capacity, file->count + 1, sizeof *file->node,
                   "the nodes of a solid"));
    scad_node *parent = &file->node[s->open];
    if (file->count > 0 && parent->last)
        file->node[parent->last].next = file->count;
    else if (file->count > 0)
        parent->first = file->count;
    if (file->count > 0)
        parent->last = file->count;
    file->node[file->count++] = *made;
    return GRAZE_OK;
}

static graze_status scan_node(scan *s) {
    scad_node n = {.parent = s->open};
    for (; next_byte(s) && strchr("#%*!", s->text[s->at]); s->at++)
        n.mark = s->text[s->at] == '#' ? n.mark : s->text[s->at];
    n.line = s->line;
    n.name = scan_name(s);
    if (n.name.length == 0)
        return fail_here(s, "expected a node, such as sphere(r = 1);");
    if (next_byte(s) != '(')
        return fail_here(s, "expected ( after a name");
    s->at++;
    TRY(scan_arguments(&n.arguments, s));
    TRY(add_node(s, &n));
    char after = next_byte(s);
    if (after != ';' && after != '{')
        return fail_here(s, "expected ; or { after )");
    s->at++;
    if (after == '{') {
        s->open = s->file->count - 1;
        if (++s->depth > s->context->limits[GRAZE_LIMIT_DEPTH])
            return limit_here(s, GRAZE_LIMIT_DEPTH, "nesting of nodes");
    }
    return GRAZE_OK;
}

static graze_status scan_nodes(scan *s) {
    graze_status status = add_node(s, &(scad_node){.line = 1});
    for (char c = next_byte(s); c && !status; c = next_byte(s)) {
        if (c == '}' && s->depth == 0)
            return fail_here(s, "expected no } here: none is open");
        if (c == '}') {
            s->open = s->file->node[s->open].parent;
            s->depth--;
            s->at++;
        } else {
            status = scan_node(s);
        }
    }
    if (!status && s->at < s->length)
        return fail_here(s, "a NUL byte; expected text");
    if (!status && s->depth > 0)
        return fail_here(s, "the file ends before a { is closed");
    return status;
}

/* Apply the marks, and find the roles of the nodes that are part of the solid. */
static graze_status take_parts(scad *file, graze_context *context) {
    for (size_t n = 1; n < file->count && !file->root; n++)
        if (file->node[n].mark == '!')
            file->root = n;
    file->node[0].absent = file->root > 0;
    for (size_t k = 1; k < file->count; k++) {
        scad_node *n = &file->node[k];
        n->absent =
            k != file->root && (file->node[n->parent].absent || n->mark == '%' || n->mark == '*');
        if (n->absent)
            continue;
        size_t r = 0, known = sizeof roles / sizeof *roles;
        while (r < known && !field_is(n->name, roles[r].name))
            r++;
        if (r == known)
            return scad_fail(&(scad_place){file, context, k}, GRAZE_EINPUT,
                             "not taken; expected cubes, spheres, "
                             "cylinders, polyhedra, squares, circles and polygons, moved, "
                             "combined and extruded");
        n->role = roles[r].role;
        if (n->first && n->role >= SCAD_CUBE)
            return scad_fail(&(scad_place){file, context, k}, GRAZE_EINPUT,
                             "expected ; after it, no nodes");
    }
    return GRAZE_OK;
}

size_t scad_next(const scad *file, size_t child) {
    do
        child = file->node[child].next;
    while (child && file->node[child].absent);
    return child;
}

size_t scad_first(const scad *file, size_t node) {
    size_t child = file->node[node].first;
    return child && file->node[child].absent ? scad_next(file, child) : child;
}

/* Take a node as empty, which counts. */
static void take_nothing(scad_nothing *count, scad_node *n) {
    if (n->empty)
        return;
    n->empty = 1;
    count->first = count->parts++ && count->first < n->line ? count->first : n->line;
}

/* Take a node that is empty by itself as empty. */
static void take_if_nothing(scad *file, graze_context *context, size_t k) {
    if (!file->node[k].empty && scad_is_nothing(&(scad_place){file, context, k}))
        take_nothing(&file->nothing, &file->node[k]);
}

/* Find whether a node is empty, and its dimension, from its children. Those of another dimension
 * than the first one, in an extrusion those of space, are empty, as OpenSCAD has it. */
static void take_dimension(scad *file, graze_context *context, size_t k) {
    scad_node *n = &file->node[k];
    int extruded = n->role == SCAD_EXTRUSION || n->role == SCAD_REVOLUTION, some = 0, held = 0;
    int flat = extruded || n->role == SCAD_OFFSET;
    size_t first = scad_first(file, k);
    n->dimension = n->role >= SCAD_SQUARE || flat ? 2 : n->role >= SCAD_CUBE ? 3 : 0;
    for (size_t c = first; c; c = scad_next(file, c)) {
        scad_node *child = &file->node[c];
        n->dimension = n->dimension ? n->dimension : child->dimension;
        if (child->dimension && child->dimension != n->dimension)
            take_nothing(&file->mixed, child);
        held |= child->dimension && child->dimension == n->dimension;
        n->empty |= n->role == SCAD_INTERSECTION && child->empty;
        some |= !child->empty;
    }
    n->empty |=
        n->role < SCAD_CUBE && (!some || (n->role == SCAD_DIFFERENCE && file->node[first].empty));
    take_if_nothing(file, context, k);
    if (extruded)
        n->dimension = held ? 3 : 0;
}

graze_status scad_parse(scad *out, graze_context *context, const char *source, const char *text,
                        size_t length) {
    *out = (scad){.source = source};
    scan s = {.context = context, .file = out, .text = text, .length = length, .line = 1};
    TRY(scan_nodes(&s));
    TRY(take_parts(out, context));
    for (size_t k = out->count; k-- > 0;)
        if (!out->node[k].absent)
            take_dimension(out, context, k);
    if (out->node[out->root].empty)
        return context_fail_in(context, GRAZE_EILLEGAL, source, 0,
                               "empty; expected a solid of OpenSCAD");
    return GRAZE_OK;
}

void scad_clear(scad *file) {
    free(file->node);
    *file = (scad){.source = NULL};
}
