/* The text of a selective Nef complex: grammar, counts, indices in range.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Counts are compared with the file's size before anything is allocated. Functions do nothing once
 * n->status is a failure, so that an item is read by a plain sequence of calls.
 */
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "input/read/nef3_text.h"

enum { ITEM_BYTES_LEAST = 7 };

static const char *const kind_name[NEF_KIND_COUNT] = {
    "vertices", "halfedges", "facets", "volumes", "shalfedges", "shalfloops", "sfaces"};

/* The next token; an empty one on failure. */
static token next(nef *n, const char *expected) {
    token t = {"", 0};
    if (n->status == GRAZE_OK && !lines_any(&n->l, &t)) {
        n->status = lines_fail(&n->l, GRAZE_EINPUT, "the file ends; expected %s", expected);
        t = (token){"", 0};
    }
    return t;
}

static void nef_expect(nef *n, const char *word) {
    token t = next(n, word);
    if (n->status == GRAZE_OK && (t.length != strlen(word) || memcmp(t.text, word, t.length) != 0))
        n->status = lines_fail(&n->l, GRAZE_EINPUT, "'%.*s'; expected '%s'", TOKEN_SHOWN(t), word);
}

static long long integer(nef *n, const char *expected) {
    long long value = 0;
    token t = next(n, expected);
    if (n->status == GRAZE_OK && !token_integer(t, &value))
        n->status =
            lines_fail(&n->l, GRAZE_EINPUT, "'%.*s'; expected %s", TOKEN_SHOWN(t), expected);
    return n->status == GRAZE_OK ? value : 0;
}

/* Read the index of an item of a kind; with `optional`, -2 is read as NEF_NONE. */
static size_t reference(nef *n, enum nef_kind kind, int optional) {
    long long value = integer(n, "an index");
    if (n->status != GRAZE_OK || (optional && value == -2))
        return n->status == GRAZE_OK ? NEF_NONE : 0;
    if (value < 0 || (size_t)value >= n->count[kind]) {
        n->status = lines_fail(&n->l, GRAZE_EINPUT, "%lld is not an index of the %zu %s", value,
                               n->count[kind], kind_name[kind]);
        return 0;
    }
    return (size_t)value;
}

static int flag(nef *n, const char *expected) {
    long long value = integer(n, expected);
    if (n->status == GRAZE_OK && value != 0 && value != 1)
        n->status = lines_fail(&n->l, GRAZE_EINPUT, "%s is %lld; expected 0 or 1", expected, value);
    return (int)value;
}

/* Read indices up to the comma or brace that ends their list. */
static nef_list indices(nef *n, enum nef_kind kind) {
    nef_list list = {n->list_count, 0};
    for (;;) {
        lines ahead = n->l;
        token t;
        if (n->status != GRAZE_OK || !lines_any(&ahead, &t) || token_is(t, ",") || token_is(t, "}"))
            return list;
        n->list[n->list_count++] = reference(n, kind, 0);
        list.count++;
    }
}

/* Read 4 integers into `out`, or skip them if `out` is NULL. */
static void integers(nef *n, fmpz *out) {
    LOCAL(fmpq, value);
    for (int k = 0; k < 4; k++) {
        token t = next(n, "an integer");
        if (n->status != GRAZE_OK)
            break;
        n->status = rational_parse(value, n->l.context, t.text, t.length);
        if (n->status != GRAZE_OK) {
            n->status = lines_at(&n->l, n->status);
        } else if (!fmpz_is_one(fmpq_denref(value))) {
            n->status =
                lines_fail(&n->l, GRAZE_EINPUT, "'%.*s'; expected an integer", TOKEN_SHOWN(t));
        } else if (out != NULL) {
            fmpz_set(out + k, fmpq_numref(value));
        }
    }
}

/* Read a point, given by four homogeneous coordinates. */
static void homogeneous(nef *n, fmpq *point) {
    LOCAL_VEC(fmpz, h, 4);
    integers(n, h);
    if (n->status == GRAZE_OK && fmpz_is_zero(h + 3))
        n->status = lines_fail(&n->l, GRAZE_EINPUT, "the last homogeneous coordinate is 0");
    for (int k = 0; k < 3 && n->status == GRAZE_OK; k++)
        fmpq_set_fmpz_frac(point + k, h + k, h + 3);
}

/* Read an index and the mark behind it. */
static size_t linked(nef *n, enum nef_kind kind, const char *mark) {
    size_t index = reference(n, kind, 0);
    nef_expect(n, mark);
    return index;
}

/* Read a list and the comma behind it. */
static nef_list listed(nef *n, enum nef_kind kind) {
    nef_list list = indices(n, kind);
    nef_expect(n, ",");
    return list;
}

/* Check that an item begins with its index among the items of its kind, and a brace. */
static void begin_item(nef *n, enum nef_kind kind, size_t index) {
    long long value = integer(n, "the number of an item");
    if (n->status == GRAZE_OK && (value < 0 || (size_t)value != index))
        n->status = lines_fail(&n->l, GRAZE_EINPUT, "item %lld; expected number %zu of the %zu %s",
                               value, index, n->count[kind], kind_name[kind]);
    nef_expect(n, "{");
}

static int end_item(nef *n) {
    nef_expect(n, "}");
    return flag(n, "a mark");
}

static void read_nef_vertex(nef *n, size_t v) {
    static const enum nef_kind kinds[3] = {NEF_HALFEDGE, NEF_SHALFEDGE, NEF_SFACE};
    nef_vertex *item = n->vertex + v;
    for (int k = 0; k < 3; k++) {
        item->part[k][0] = reference(n, kinds[k], 1);
        item->part[k][1] = reference(n, kinds[k], 1);
        nef_expect(n, ",");
    }
    item->loop = reference(n, NEF_SHALFLOOP, 1);
    nef_expect(n, "|");
    homogeneous(n, n->point + 3 * v);
    item->mark = end_item(n);
}

static void read_halfedge(nef *n, size_t e) {
    nef_halfedge *item = n->halfedge + e;
    item->twin = linked(n, NEF_HALFEDGE, ",");
    item->source = linked(n, NEF_VERTEX, ",");
    item->isolated = flag(n, "the sign of an isolated half-edge");
    item->incident = linked(n, item->isolated ? NEF_SFACE : NEF_SHALFEDGE, "|");
    integers(n, NULL);
    item->mark = end_item(n);
}

static void read_halffacet(nef *n, size_t f) {
    nef_halffacet *item = n->halffacet + f;
    item->twin = linked(n, NEF_HALFFACET, ",");
    item->cycle = listed(n, NEF_SHALFEDGE);
    item->loop = listed(n, NEF_SHALFLOOP);
    item->volume = linked(n, NEF_VOLUME, "|");
    integers(n, n->plane + 4 * f);
    item->mark = end_item(n);
}

static void read_volume(nef *n, size_t c) {
    n->volume[c].shell = indices(n, NEF_SFACE);
    n->volume[c].mark = end_item(n);
}

static void read_shalfedge(nef *n, size_t e) {
    nef_shalfedge *item = n->shalfedge + e;
    item->twin = linked(n, NEF_SHALFEDGE, ",");
    item->sprev = linked(n, NEF_SHALFEDGE, ",");
    item->snext = linked(n, NEF_SHALFEDGE, ",");
    item->source = linked(n, NEF_HALFEDGE, ",");
    item->sface = linked(n, NEF_SFACE, ",");
    item->prev = linked(n, NEF_SHALFEDGE, ",");
    item->next = linked(n, NEF_SHALFEDGE, ",");
    item->facet = linked(n, NEF_HALFFACET, "|");
    integers(n, NULL);
    item->mark = end_item(n);
}

static void read_shalfloop(nef *n, size_t l) {
    nef_shalfloop *item = n->shalfloop + l;
    item->twin = linked(n, NEF_SHALFLOOP, ",");
    item->sface = linked(n, NEF_SFACE, ",");
    item->facet = linked(n, NEF_HALFFACET, "|");
    integers(n, NULL);
    item->mark = end_item(n);
}

static void read_sface(nef *n, size_t f) {
    nef_sface *item = n->sface + f;
    item->vertex = linked(n, NEF_VERTEX, ",");
    item->arc = listed(n, NEF_SHALFEDGE);
    item->point = listed(n, NEF_HALFEDGE);
    item->loop = listed(n, NEF_SHALFLOOP);
    item->volume = reference(n, NEF_VOLUME, 0);
    item->mark = end_item(n);
}

static void read_items(nef *n, enum nef_kind kind, void (*read)(nef *, size_t)) {
    for (size_t k = 0; k < n->count[kind] && n->status == GRAZE_OK; k++) {
        begin_item(n, kind, k);
        read(n, k);
        if (n->status == GRAZE_OK && (k & 0xfff) == 0xfff)
            n->status = context_poll(n->l.context);
    }
}

static void nef_counts(nef *n, size_t length) {
    unsigned long limit = n->l.context->limits[GRAZE_LIMIT_CELLS];
    for (int k = 0; k < NEF_KIND_COUNT && n->status == GRAZE_OK; k++) {
        nef_expect(n, kind_name[k]);
        long long value = integer(n, "a count");
        if (n->status != GRAZE_OK)
            return;
        int paired =
            k == NEF_HALFEDGE || k == NEF_HALFFACET || k == NEF_SHALFEDGE || k == NEF_SHALFLOOP;
        if (value < 0 || (paired && value % 2 != 0)) {
            n->status = lines_fail(&n->l, GRAZE_EINPUT, "the number of %s is %lld; expected %s",
                                   kind_name[k], value, paired ? "an even number" : "0 or more");
        } else if ((k == NEF_VERTEX || k == NEF_HALFFACET) &&
                   (unsigned long)value / (paired ? 2 : 1) > limit) {
            n->status =
                lines_at(&n->l, context_limit(n->l.context, GRAZE_LIMIT_CELLS, kind_name[k]));
        } else if ((size_t)value > length / ITEM_BYTES_LEAST) {
            n->status = lines_fail(&n->l, GRAZE_EINPUT,
                                   "%lld %s are declared, more than the file's %zu bytes can hold",
                                   value, kind_name[k], length);
        }
        n->count[k] = (size_t)value;
    }
}

static void *zeroed(nef *n, size_t count, size_t size) {
    void *memory = n->status == GRAZE_OK ? calloc(count + 1, size) : NULL;
    if (n->status == GRAZE_OK && memory == NULL)
        n->status = nef_fail(n, GRAZE_ESYSTEM, "out of memory for a Nef polyhedron");
    return memory;
}

/* Zeroed memory is valid as FLINT integers, but not as rationals, whose denominators begin as 1. */
static void allocate(nef *n, size_t length) {
    const size_t *c = n->count;
    n->vertex = zeroed(n, c[NEF_VERTEX], sizeof *n->vertex);
    n->halfedge = zeroed(n, c[NEF_HALFEDGE], sizeof *n->halfedge);
    n->halffacet = zeroed(n, c[NEF_HALFFACET], sizeof *n->halffacet);
    n->volume = zeroed(n, c[NEF_VOLUME], sizeof *n->volume);
    n->shalfedge = zeroed(n, c[NEF_SHALFEDGE], sizeof *n->shalfedge);
    n->shalfloop = zeroed(n, c[NEF_SHALFLOOP], sizeof *n->shalfloop);
    n->sface = zeroed(n, c[NEF_SFACE], sizeof *n->sface);
    n->point = zeroed(n, 3 * c[NEF_VERTEX], sizeof *n->point);
    n->plane = zeroed(n, 4 * c[NEF_HALFFACET], sizeof *n->plane);
    n->list = zeroed(n, length / 2 + 1, sizeof *n->list); /* an index and a blank are two bytes */
    for (size_t k = 0; n->point != NULL && k < 3 * c[NEF_VERTEX]; k++)
        fmpq_init(n->point + k);
}

graze_status nef_parse(nef *n, graze_context *context, const char *path, const char *text,
                       size_t length) {
    *n = (nef){.l = {.context = context, .path = path, .marks = "{},|"}};
    n->status = lines_start(&n->l, text, length);
    nef_expect(n, "Selective");
    nef_expect(n, "Nef");
    nef_expect(n, "Complex");
    token kernel = next(n, "'standard'");
    if (n->status == GRAZE_OK && token_is(kernel, "extended")) {
        n->status = lines_fail(&n->l, GRAZE_EILLEGAL,
                               "unbounded: an extended Nef polyhedron; expected a standard one");
    } else if (n->status == GRAZE_OK && !token_is(kernel, "standard")) {
        n->status = lines_fail(&n->l, GRAZE_EINPUT, "the kernel is '%.*s'; expected standard",
                               TOKEN_SHOWN(kernel));
    }
    nef_counts(n, length);
    allocate(n, length);
    read_items(n, NEF_VERTEX, read_nef_vertex);
    read_items(n, NEF_HALFEDGE, read_halfedge);
    read_items(n, NEF_HALFFACET, read_halffacet);
    read_items(n, NEF_VOLUME, read_volume);
    read_items(n, NEF_SHALFEDGE, read_shalfedge);
    read_items(n, NEF_SHALFLOOP, read_shalfloop);
    read_items(n, NEF_SFACE, read_sface);
    static const char *const last[] = {"/*", "end", "Selective", "Nef", "complex", "*/"};
    for (size_t k = 0; k < sizeof last / sizeof *last; k++)
        nef_expect(n, last[k]);
    token t;
    if (n->status == GRAZE_OK && lines_any(&n->l, &t))
        n->status = lines_fail(&n->l, GRAZE_EINPUT, "'%.*s' follows the end of the complex",
                               TOKEN_SHOWN(t));
    return n->status;
}

void nef_clear(nef *n) {
    for (size_t k = 0; n->point != NULL && k < 3 * n->count[NEF_VERTEX]; k++)
        fmpq_clear(n->point + k);
    for (size_t k = 0; n->plane != NULL && k < 4 * n->count[NEF_HALFFACET]; k++)
        fmpz_clear(n->plane + k);
    free(n->vertex);
    free(n->halfedge);
    free(n->halffacet);
    free(n->volume);
    free(n->shalfedge);
    free(n->shalfloop);
    free(n->sface);
    free(n->point);
    free(n->plane);
    free(n->list);
}
