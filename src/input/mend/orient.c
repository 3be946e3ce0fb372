/* Orients the facets of a mesh.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Facets that share an edge of just two facets belong to one shell, which can be oriented in two
 * ways. A shell that is legal by itself in one of them bounds a solid. Shells of a legal solid do
 * not cross, so a shell is inside another if one of its points is; a shell inside an odd number of
 * others is turned. Whether the result is legal is not decided here.
 */
#include "base/context/scope.h"
#include "input/mend/mesh.h"

/* The time grows with the square of the number of shells. */
enum { SHELLS_MOST = 1000 };

typedef struct orienter {
    mesh *m;
    unsigned flags;
    size_t *shell;         /* by facet: first an earlier facet of its shell or itself, later the
                            * shell's number */
    unsigned char *turned; /* by facet: first 1 if it runs against that facet, later 1 if it is to
                            * be reversed */
    size_t shell_count;
    graze_solid **solid; /* by shell: its solid, facing outward; NULL: it bounds nothing */
} orienter;

/* The first facet of the shell, and whether the facet runs against it. */
static size_t root_of_part(const orienter *o, size_t facet, unsigned char *against) {
    *against = 0;
    while (o->shell[facet] != facet) {
        *against ^= o->turned[facet];
        facet = o->shell[facet];
    }
    return facet;
}

/* Join the shells of two facets at an edge; 0 if they are one shell already, in which both facets
 * run along the edge in the same sense. */
static int join_facets(orienter *o, const mesh_side *a, const mesh_side *b) {
    unsigned char one, two, against = a->ascends == b->ascends;
    size_t first = root_of_part(o, a->facet, &one), second = root_of_part(o, b->facet, &two);
    if (first == second)
        return (one ^ two) == against;
    if (second < first) {
        size_t swap = first;
        first = second;
        second = swap;
    }
    o->shell[second] = first;
    o->turned[second] = one ^ two ^ against;
    for (int k = 0; k < 2; k++) { /* short paths: both facets hang at the root */
        size_t facet = k ? b->facet : a->facet;
        unsigned char way;
        size_t root = root_of_part(o, facet, &way);
        if (facet != root) {
            o->shell[facet] = root;
            o->turned[facet] = way;
        }
    }
    return 1;
}

static graze_status find_shells(orienter *o) {
    FREED(mesh_side, side, NULL);
    size_t count = 0;
    TRY(mesh_sides(&side, &count, o->m));
    for (size_t first = 0, end; first < count; first = end) {
        end = mesh_edge_end(side, count, first);
        if (end - first == 2 && !join_facets(o, &side[first], &side[first + 1]))
            return context_fail(o->m->context, GRAZE_EILLEGAL,
                                "facets %zu and %zu, which share edge %u-%u, belong to a surface "
                                "with one side only; expected one that can be oriented",
                                o->m->now.origin.item[side[first].facet],
                                o->m->now.origin.item[side[first + 1].facet], side[first].low,
                                side[first].high);
    }
    return GRAZE_OK;
}

/* Number the shells by their first facets. */
static void number_shells(orienter *o) {
    for (size_t f = 0; f < o->m->now.of.cycle_count; f++) {
        unsigned char against;
        size_t root = root_of_part(o, f, &against);
        o->turned[f] = against;
        o->shell[f] = root; /* paths through f keep their root and their sense */
    }
    for (size_t f = 0; f < o->m->now.of.cycle_count; f++)
        o->shell[f] = o->shell[f] == f ? o->shell_count++ : o->shell[o->shell[f]];
}

static void turn_shell(orienter *o, size_t shell) {
    for (size_t f = 0; f < o->m->now.of.cycle_count; f++)
        if (o->shell[f] == shell)
            o->turned[f] ^= 1;
}

/* Make a solid of one shell as it is or else turned. If neither is legal, the shell has no solid
 * and stays as it was. */
static graze_status make_shell(orienter *o, size_t shell) {
    graze_status status = GRAZE_EILLEGAL;
    for (int turn = 0; turn < 2 && status == GRAZE_EILLEGAL; turn++) {
        soup input;
        if (turn)
            turn_shell(o, shell);
        status = mesh_soup(&input, o->m, o->shell, shell, o->turned);
        if (!status)
            status = solid_create(&o->solid[shell], o->m->context, &input, o->flags);
    }
    if (status == GRAZE_EILLEGAL)
        turn_shell(o, shell);
    return status == GRAZE_EILLEGAL ? GRAZE_OK : status;
}

/* Is a shell inside another? A vertex of the shell that is not on the other's boundary decides; if
 * all are on it, a point inside a facet does. */
static int is_within_part(const graze_solid *shell, const graze_solid *other) {
    graze_state state = GRAZE_STATE_B;
    LOCAL_VEC(fmpz, x, 4);
    size_t vertices = shell->input.vertex_count, points = vertices + shell->cut.count;
    for (size_t k = 0; k < points && state == GRAZE_STATE_B; k++) {
        if (k < vertices)
            _fmpq_vec_get_fmpz_vec_fmpz(x, x + 3, shell->input.coordinates + 3 * k, 3);
        else
            solid_point_within(x, shell, k - vertices, 1);
        state = solid_locate(other, x);
    }
    return state == GRAZE_STATE_I;
}

/* Turn the shells that are inside an odd number of others. */
static graze_status turn_cavities(orienter *o) {
    FREED(unsigned char, odd, NULL);
    TRY(MAKE_ARRAY(o->m->context, odd, o->shell_count + 1, "shells"));
    for (size_t a = 0; a < o->shell_count; a++)
        for (size_t b = 0; b < o->shell_count; b++) {
            TRY(context_poll(o->m->context));
            if (a != b && o->solid[a] && o->solid[b] &&
                box_meets(&o->solid[a]->boxes.node[0].box, &o->solid[b]->boxes.node[0].box))
                odd[a] ^= (unsigned char)is_within_part(o->solid[a], o->solid[b]);
        }
    for (size_t a = 0; a < o->shell_count; a++)
        if (odd[a])
            turn_shell(o, a);
    return GRAZE_OK;
}

static void apply_turns(orienter *o) {
    soup *f = &o->m->now.of;
    few turned = {0, {NULL, 0, 0, 0}};
    for (size_t k = 0; k < f->cycle_count; k++) {
        if (!o->turned[k])
            continue;
        few_add(&turned, "%zu", o->m->now.origin.item[k]);
        for (size_t low = f->cycle_start[k], high = f->cycle_start[k + 1] - 1; low < high;
             low++, high--) {
            uint32_t swap = f->index[low];
            f->index[low] = f->index[high];
            f->index[high] = swap;
        }
    }
    few_report(&turned, o->m, "turned", "facets round");
}

static graze_status orient_shells(orienter *o) {
    TRY(find_shells(o));
    number_shells(o);
    if (o->shell_count > SHELLS_MOST)
        return context_fail(o->m->context, GRAZE_EILLEGAL,
                            "the facets make %zu shells, which are not oriented; expected at most "
                            "%d to orient",
                            o->shell_count, SHELLS_MOST);
    TRY(MAKE_ARRAY(o->m->context, o->solid, o->shell_count + 1, "shells"));
    graze_status status = GRAZE_OK;
    for (size_t k = 0; k < o->shell_count && !status; k++)
        status = make_shell(o, k);
    if (!status)
        status = turn_cavities(o);
    if (!status)
        apply_turns(o);
    for (size_t k = 0; k < o->shell_count; k++)
        graze_solid_destroy(o->solid[k]);
    free(o->solid);
    return status;
}

graze_status orient_facets(mesh *m, unsigned flags) {
    size_t n = m->now.of.cycle_count;
    FREED(size_t, shell, malloc((n + 1) * sizeof *shell));
    FREED(unsigned char, turned, calloc(n + 1, 1));
    orienter o = {.m = m, .flags = flags, .shell = shell, .turned = turned};
    if (!shell || !turned)
        return context_fail(m->context, GRAZE_ESYSTEM, "out of memory for facets");
    for (size_t k = 0; k < n; k++)
        shell[k] = k;
    return orient_shells(&o);
}
