/* Circuits of gradients, and the signs of a surface along the other surfaces of its circuit.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Of a circuit with the relation sum mu_k g_k = 0 every pattern occurs but perhaps the two with
 * s_k = e sgn mu_k, e = 1 or -1 (C96). Near the point f_m = sum alpha_k f_k + phi, the alpha_k
 * units of the sign of -mu_k / mu_m, phi the last member where the others are 0: the pattern
 * occurs iff phi takes the sign e sgn mu_m arbitrarily near (C97).
 */
#include "base/context/scope.h"
#include "decide/curved/arrangement.h"

/* Whether a function takes a sign arbitrarily near the point. */
typedef enum taking { TAKES_NOT, TAKES, TAKES_PERHAPS } taking;

typedef struct takings {
    taking plus, minus;
} takings;

static const takings none = {TAKES_NOT, TAKES_NOT}, both = {TAKES, TAKES},
                     unknown = {TAKES_PERHAPS, TAKES_PERHAPS};

/* The members of a circuit, and the signs of their factors in the relation. */
typedef struct circuit {
    int size, member[4], sign[4];
} circuit;

static takings takes_one(int sign, taking other) {
    return sign > 0 ? (takings){TAKES, other} : (takings){other, TAKES};
}

static unsigned members_of(const circuit *c) {
    unsigned mask = 0;
    for (int k = 0; k < c->size; k++)
        mask |= 1u << c->member[k];
    return mask;
}

/* Signs that a member takes along the curve in which the members before it meet. */
static takings take_on_curve(sign_germ *g, const circuit *c) {
    const taylor *base[2], *last = &g->member[c->member[c->size - 1]];
    const slong forward[] = {1, 0, 0};
    int order, most = last->degree;
    probe p;
    for (int k = 0; k < c->size - 1; k++) {
        base[k] = &g->member[c->member[k]];
        most *= base[k]->degree;
    }
    takings out = unknown;
    if (probe_init(&p, g->f, g->dimension, base, c->size - 1)) {
        probe_set_integers(&p, forward);
        int sign = flow_first(&order, g, &p, members_of(c), last, most);
        out = sign == 0 ? none : order % 2 ? both : takes_one(sign, TAKES_NOT);
    }
    probe_clear(&p);
    return out;
}

/* The three coefficients of the quadratic form of `of` on the surface of a probe, in the open
 * coordinates: of x^2, of y^2, and 2 b of 2 b x y; and the sign of the discriminant 4 a c - 4 b^2.
 */
static int form_on_surface(value *form, sign_germ *g, probe *p, const taylor *of) {
    static const slong direction[3][2] = {{1, 0}, {0, 1}, {1, 1}};
    for (int k = 0; k < 3; k++) {
        probe_set_integers(p, direction[k]);
        probe_second(form + k, p, g->f, of);
    }
    fmpq_poly_sub(form + 2, form + 2, form);
    fmpq_poly_sub(form + 2, form + 2, form + 1);
    LOCAL(fmpq_poly, left);
    field_mul(left, g->f, form, form + 1);
    fmpq_poly_scalar_mul_si(left, left, 4);
    field_submul(left, g->f, form + 2, form + 2);
    return field_sign(g->f, left);
}

/* Signs that phi takes if its quadratic form has rank 1 and the sign `sign`: that sign, and those
 * along the curve on which phi's derivative in the open coordinate `axis` is 0 (C98). */
static takings take_on_ridge(sign_germ *g, const circuit *c, const probe *on, int axis, int sign) {
    const slong forward[] = {1, 0, 0};
    const taylor *base = on->base[0], *of = &g->member[c->member[1]];
    int order, most = of->degree * base->degree * (of->degree + base->degree - 2);
    takings out = unknown;
    taylor ridge;
    probe p;
    taylor_init(&ridge, g->f, g->dimension);
    if (g->f->status == GRAZE_OK)
        taylor_minor(&ridge, g->f, of, base, on->open_axis[axis], on->bound_axis[0]);
    const taylor *pair[] = {base, &ridge};
    if (probe_init(&p, g->f, g->dimension, pair, 2)) {
        probe_set_integers(&p, forward);
        int rest = flow_first(&order, g, &p, members_of(c), of, most);
        int other = rest != 0 && (order % 2 || rest == -sign);
        out = takes_one(sign, other ? TAKES : TAKES_NOT);
    }
    probe_clear(&p);
    taylor_clear(&ridge);
    return out;
}

/* Signs that phi takes if its quadratic form vanishes: those of its first terms along some
 * directions. A lowest form of odd degree below the number of directions does not vanish along all
 * of them. */
static takings take_flat(sign_germ *g, probe *p, const taylor *of) {
    static const slong direction[8][2] = {{1, 0}, {0, 1}, {1, 1},  {1, -1},
                                          {1, 2}, {2, 1}, {1, -2}, {2, -1}};
    int plus = 0, minus = 0, most = of->degree * p->base[0]->degree;
    for (int k = 0; k < 8; k++) {
        int order;
        probe_set_integers(p, direction[k]);
        int sign = probe_first(&order, p, g->f, of, most);
        plus |= sign > 0 || (sign != 0 && order % 2);
        minus |= sign < 0 || (sign != 0 && order % 2);
    }
    return plus && minus ? both
           : plus        ? takes_one(1, TAKES_PERHAPS)
           : minus       ? takes_one(-1, TAKES_PERHAPS)
                         : unknown;
}

/* Signs that a member takes on a surface in space that it touches. */
static takings take_on_surface(sign_germ *g, const circuit *c) {
    const taylor *base = &g->member[c->member[0]], *of = &g->member[c->member[1]];
    takings out = unknown;
    probe p;
    LOCAL_VEC(fmpq_poly, form, 3);
    if (probe_init(&p, g->f, g->dimension, &base, 1)) {
        int discriminant = form_on_surface(form, g, &p, of);
        int first = field_sign(g->f, form), second = field_sign(g->f, form + 1);
        int mixed = field_sign(g->f, form + 2);
        if (discriminant < 0)
            out = both;
        else if (discriminant > 0)
            out = takes_one(first, TAKES_NOT);
        else if (first || second)
            out = take_on_ridge(g, c, &p, first ? 0 : 1, first ? first : second);
        else if (!mixed)
            out = take_flat(g, &p, of);
    }
    probe_clear(&p);
    return out;
}

static int is_linear(const sign_germ *g, const circuit *c) {
    for (int k = 0; k < c->size; k++)
        if (g->member[c->member[k]].degree > 1)
            return 0;
    return 1;
}

/* Note what is known of the pattern with the signs of the relation times e. */
static void note_taking(sign_germ *g, const circuit *c, int e, taking known) {
    unsigned want = 0;
    for (int k = 0; k < c->size; k++)
        want |= (unsigned)(e * c->sign[k] < 0) << c->member[k];
    if (known == TAKES_NOT)
        germ_exclude(g, members_of(c), want);
    if (known == TAKES && c->size == g->count)
        pattern_add(&g->seen, want);
}

/* Note what a circuit says of the patterns. Its last member is not a plane unless all members are.
 */
static void ask_circuit(sign_germ *g, const circuit *c) {
    int last = c->sign[c->size - 1];
    takings t = is_linear(g, c) || c->size == g->dimension + 1 ? none
                : c->size == g->dimension                      ? take_on_curve(g, c)
                                                               : take_on_surface(g, c);
    note_taking(g, c, last, t.plus);
    note_taking(g, c, -last, t.minus);
}

/* Minors of the gradients: all that circuits depend on. */
typedef struct minors {
    unsigned smooth; /* the members whose gradients are not zero */
    value *normal;   /* 3 of each member */
    int parallel[CSG_FREE_MOST][CSG_FREE_MOST];
} minors;

/* The cross product of the gradients of two members; in the plane its third coordinate alone is not
 * 0. */
static void cross_members(value *out, const sign_germ *g, const minors *m, int i, int j) {
    field_cross(out, g->f, m->normal + 3 * i, m->normal + 3 * j);
}

static int sign_of_dot(const sign_germ *g, const value *a, const value *b) {
    LOCAL(fmpq_poly, product);
    field_dot(product, g->f, a, b, 3);
    return field_sign(g->f, product);
}

static int sign_of_triple(const sign_germ *g, const minors *m, int i, int j, int k) {
    LOCAL_VEC(fmpq_poly, cross, 3);
    cross_members(cross, g, m, i, j);
    return sign_of_dot(g, cross, m->normal + 3 * k);
}

static int is_zero_value(const sign_germ *g, const value *a) {
    for (int i = 0; i < 3; i++)
        if (field_sign(g->f, a + i) != 0)
            return 0;
    return 1;
}

static int are_smooth(const minors *m, unsigned members) {
    return (m->smooth & members) == members;
}

static void ask_pairs(sign_germ *g, minors *m) {
    LOCAL_VEC(fmpq_poly, cross, 3);
    for (int j = 0; j < g->count; j++)
        for (int i = 0; i < j && g->f->status == GRAZE_OK; i++) {
            if (!are_smooth(m, 1u << i | 1u << j))
                continue;
            cross_members(cross, g, m, i, j);
            m->parallel[i][j] = m->parallel[j][i] = is_zero_value(g, cross);
            if (!m->parallel[i][j])
                continue;
            int same = sign_of_dot(g, m->normal + 3 * i, m->normal + 3 * j);
            ask_circuit(g, &(circuit){2, {i, j}, {1, -same}});
        }
}

/* Ask the circuit of three members whose gradients lie in one plane, no two of them parallel. */
static void ask_coplanar(sign_germ *g, const minors *m, int i, int j, int k) {
    LOCAL_VEC(fmpq_poly, cross, 9);
    cross_members(cross, g, m, j, k);
    cross_members(cross + 3, g, m, k, i);
    cross_members(cross + 6, g, m, i, j);
    int first = sign_of_dot(g, cross, cross + 6), second = sign_of_dot(g, cross + 3, cross + 6);
    ask_circuit(g, &(circuit){3, {i, j, k}, {first, second, 1}});
}

static void ask_triples(sign_germ *g, const minors *m) {
    for (int k = 0; k < g->count; k++)
        for (int j = 0; j < k; j++)
            for (int i = 0; i < j && g->f->status == GRAZE_OK; i++)
                if (are_smooth(m, 1u << i | 1u << j | 1u << k) && !m->parallel[i][j] &&
                    !m->parallel[i][k] && !m->parallel[j][k] &&
                    (g->dimension == 2 || sign_of_triple(g, m, i, j, k) == 0))
                    ask_coplanar(g, m, i, j, k);
}

/* Ask each four members in space with any three independent; Cramer's rule gives their relation. */
static void ask_quadruples(sign_germ *g, const minors *m) {
    for (int l = 0; l < g->count && g->dimension == 3; l++)
        for (int k = 0; k < l; k++)
            for (int j = 0; j < k; j++)
                for (int i = 0; i < j && g->f->status == GRAZE_OK; i++) {
                    if (!are_smooth(m, 1u << i | 1u << j | 1u << k | 1u << l))
                        continue;
                    circuit c = {4,
                                 {i, j, k, l},
                                 {sign_of_triple(g, m, j, k, l), -sign_of_triple(g, m, i, k, l),
                                  sign_of_triple(g, m, i, j, l), -sign_of_triple(g, m, i, j, k)}};
                    if (c.sign[0] && c.sign[1] && c.sign[2] && c.sign[3])
                        ask_circuit(g, &c);
                }
}

void circuits_ask(sign_germ *g, unsigned smooth) {
    LOCAL_VEC(fmpq_poly, normal, 3 * g->count);
    minors m = {.smooth = smooth, .normal = normal};
    for (int k = 0; k < g->count; k++)
        for (int i = 0; i < g->dimension; i++)
            fmpq_poly_set(normal + 3 * k + i, taylor_gradient(&g->member[k], i));
    ask_pairs(g, &m);
    if (g->f->status == GRAZE_OK)
        ask_triples(g, &m);
    if (g->f->status == GRAZE_OK)
        ask_quadruples(g, &m);
}
