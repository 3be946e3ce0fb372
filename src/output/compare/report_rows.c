/* Reports on rows, as Markdown and as JSON. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/compare/compare.h"

#include "output/compare/counts.h"
#include "output/compare/judgement.h"

static const struct quantile {
    const char *name;
    unsigned long per_mille;
} quantiles[] = {{"50", 500}, {"90", 900}, {"99", 990}};

enum { QUANTILES = sizeof quantiles / sizeof *quantiles };

static const char *const conventions[CONVENTIONS] = {"on", "any", "in", "out"};

void put_share(text *out, unsigned long part, unsigned long whole) {
    unsigned long long hundredths = whole ? (20000ull * part + whole) / (2ull * whole) : 0;
    text_format(out, "%llu.%02llu %%", hundredths / 100, hundredths % 100);
}

static const char *matched_by(const graze_comparison *c) {
    return c->way == MATCH_ORDER ? "order" : c->key.by_id ? "id" : "point";
}

void put_matched(text *out, const graze_comparison *c) {
    char largest[CEILING_ROOM];
    if (c->contacts)
        return;
    text_format(out, "rows matched by: %s", matched_by(c));
    ceiling_text(largest, c->drift);
    if (c->drifted)
        text_format(out, "; %lu rows have coordinates other than the golden ones, by at most %s",
                    c->drifted, largest);
    text_put(out, "\n");
}

void put_wrong_rows(text *out, const graze_comparison *c) {
    if (c->missing) {
        text_format(out, "missing: %lu of %lu rows; of the others wrong: %lu", c->missing, c->rows,
                    c->wrong);
    } else {
        text_put(out, "wrong: ");
        put_share(out, c->wrong, c->rows);
        text_put(out, " of the rows");
    }
    for (int k = 0; k < JUDGED_COUNT; k++)
        if (c->judged[k])
            text_format(out, "; %s %lu", judged_name(k), c->column_wrong[k]);
    text_put(out, "\n");
}

void put_apart(text *out, const graze_comparison *c) {
    if (c->of_mesh)
        text_format(
            out, "on the mesh: %lu points whose golden answer is `in` or `out`, undecided here\n",
            c->apart);
}

void put_conventions(text *out, const graze_comparison *c) {
    if (!comparison_has_no_on(c))
        return;
    text_format(out,
                "conventions: %lu golden rows are `on`, which the candidate never answers; rows "
                "wrong with",
                c->golden_on);
    for (int k = 0; k < CONVENTIONS; k++)
        text_format(out, "%s `--on-as %s`: %lu", k ? "," : "", conventions[k], c->wrong_as[k]);
    text_put(out, "\n");
}

static unsigned long depths_taken(const graze_comparison *c) {
    const errors *by = c->depth.by;
    return by[PMC_IN].rows + by[PMC_ON].rows + by[PMC_OUT].rows;
}

/* Wrong rows that are deeper than parts of the size. */
static void put_parts(text *out, const depths *d) {
    char size[CEILING_ROOM];
    ceiling_text(size, ceiling_of(d->size));
    if (fmpq_is_zero(d->size))
        text_put(
            out,
            "\nNot counted by parts of the size, as the golden table has no line `# diagonal`\n");
    else
        text_format(out,
                    "\nDeeper than 1e-12, 1e-9, 1e-6, 1e-3 of the size, %s (the diagonal of the "
                    "box at the start), are for certain %lu, %lu, %lu, %lu rows\n",
                    size, d->deeper[0], d->deeper[1], d->deeper[2], d->deeper[3]);
}

void put_depths(text *out, const graze_comparison *c) {
    char number[CEILING_ROOM];
    if (c->depth.unmeasured)
        text_format(out, "\nDepth of the wrong rows: not measured, %s\n", c->depth.unmeasured);
    if (!depths_taken(c) || c->depth.unmeasured)
        return;
    text_format(
        out,
        "\nDepth of the wrong rows: upper bounds of |s|, s the signed distance to the exact "
        "set, of %lu of %lu of them, by the golden answer:\n\n| golden pmc | rows |",
        depths_taken(c), c->depth.wrong);
    for (int k = 0; k < QUANTILES; k++)
        text_format(out, " %s %% |", quantiles[k].name);
    text_put(out, " largest |\n|---|");
    for (int k = 0; k < QUANTILES + 2; k++)
        text_put(out, "--:|");
    for (int pmc = 0; pmc < 3; pmc++) {
        const errors *e = &c->depth.by[pmc];
        if (!e->rows)
            continue;
        text_format(out, "\n| %s | %lu |", pmc_words[pmc], e->rows);
        for (int k = 0; k <= QUANTILES; k++) {
            ceiling_text(number,
                         k < QUANTILES ? errors_quantile(e, quantiles[k].per_mille) : e->largest);
            text_format(out, " %s |", number);
        }
    }
    text_put(out, "\n");
    put_parts(out, &c->depth);
}

static void put_json_depths(json_writer *w, const graze_comparison *c) {
    char number[CEILING_ROOM];
    json_open(w, "depth-of-wrong-rows", '{');
    json_count(w, "wrong", c->depth.wrong);
    json_count(w, "measured", depths_taken(c));
    ceiling_text(number, ceiling_of(c->depth.size));
    json_text(w, "size", fmpq_is_zero(c->depth.size) ? NULL : number);
    json_open(w, "deeper-than", '{');
    for (int k = 0; k < DEPTH_PARTS && !fmpq_is_zero(c->depth.size); k++)
        json_count(w, depth_parts[k], c->depth.deeper[k]);
    json_close(w, '}');
    for (int pmc = 0; pmc < 3; pmc++) {
        const errors *e = &c->depth.by[pmc];
        json_open(w, pmc_words[pmc], '{');
        json_count(w, "rows", e->rows);
        json_open(w, "quantiles", '{');
        for (int k = 0; k < QUANTILES; k++) {
            ceiling_text(number, errors_quantile(e, quantiles[k].per_mille));
            json_text(w, quantiles[k].name, number);
        }
        json_close(w, '}');
        ceiling_text(number, e->largest);
        json_text(w, "largest", number);
        json_close(w, '}');
    }
    json_close(w, '}');
}

void put_json_rows(json_writer *w, const graze_comparison *c) {
    char largest[CEILING_ROOM];
    if (!c->contacts)
        json_text(w, "matched-by", matched_by(c));
    if (c->of_mesh)
        json_count(w, "on-the-mesh", c->apart);
    if (!c->contacts && (c->way == MATCH_ORDER || c->key.by_id)) {
        ceiling_text(largest, c->drift);
        json_count(w, "rows-with-other-coordinates", c->drifted);
        json_text(w, "largest-difference", largest);
    }
    if (depths_taken(c))
        put_json_depths(w, c);
    if (!comparison_has_no_on(c))
        return;
    json_open(w, "wrong-by-convention", '{');
    for (int k = 0; k < CONVENTIONS; k++)
        json_count(w, conventions[k], c->wrong_as[k]);
    json_close(w, '}');
}
