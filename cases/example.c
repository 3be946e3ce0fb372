/* One point against the sweep of cases/bracket: its class, its word, and every contact with its
 * time and the boundary cells met. From the top of the repository, after `make`:
 *
 *   cc -std=c11 -Iinclude cases/example.c -o build/example build/libgraze.a \
 *      -lyajl -lmd -lflint -lmpfr -lgmp -lstdc++ -lm -pthread
 *   build/example
 *
 * SPDX-License-Identifier: CC0-1.0
 */
#include <graze.h>
#include <stdio.h>

/* Print a time as the decimal nearest to it. */
static graze_status print_time(graze_context *context, const char *before, const graze_time *time) {
    char *text = NULL;
    graze_status status = graze_time_decimal(&text, context, time, 12);
    if (status == GRAZE_OK)
        printf("%s%s", before, text);
    graze_free(text);
    return status;
}

static void print_cell(graze_cell cell) {
    switch (cell.kind) {
    case GRAZE_CELL_FACE:
        printf(", face %zu", cell.a);
        break;
    case GRAZE_CELL_EDGE:
        printf(", edge %zu-%zu", cell.a, cell.b);
        break;
    case GRAZE_CELL_VERTEX:
        printf(", vertex %zu", cell.a);
        break;
    case GRAZE_CELL_PRIMITIVE:
        printf(", primitive %zu", cell.a);
        break;
    }
}

static graze_status print_contact(graze_context *context, graze_contact contact) {
    fputs(contact.kind == GRAZE_TANGENCY ? "touches" : "crosses", stdout);
    graze_status status = print_time(context, " at ", contact.from);
    if (status == GRAZE_OK && contact.to != contact.from)
        status = print_time(context, " to ", contact.to);
    for (size_t k = 0; status == GRAZE_OK && k < contact.cell_count; k++)
        print_cell(contact.cells[k]);
    putchar('\n');
    return status;
}

/* Class and word, then the contacts in order of time. */
static graze_status print_trace(graze_context *context, const graze_scene *scene,
                                graze_rationals point) {
    graze_trace *trace = NULL;
    graze_status status = graze_trace_create(&trace, context, scene, point);
    if (status == GRAZE_OK)
        printf("%s %s\n", graze_class_name(graze_trace_verdict(trace).class_),
               graze_trace_word(trace));
    for (size_t k = 0; status == GRAZE_OK && k < graze_trace_contact_count(trace); k++)
        status = print_contact(context, graze_trace_contact(trace, k));
    graze_trace_destroy(trace);
    return status;
}

int main(void) {
    graze_context *context = NULL;
    graze_solid *solid = NULL;
    graze_motion *motion = NULL;
    graze_scene *scene = NULL;
    mpq_t point[3]; /* 3/5, 29/5, 3 */
    mpq_inits(point[0], point[1], point[2], NULL);
    mpq_set_si(point[0], 3, 5);
    mpq_set_si(point[1], 29, 5);
    mpq_set_si(point[2], 3, 1);
    int ok = !graze_context_create(&context) &&
             !graze_solid_read(&solid, context, "cases/bracket/solid.off", 0) &&
             !graze_motion_read(&motion, context, "cases/bracket/motion.json") &&
             !graze_scene_create(&scene, context, solid, motion, NULL) &&
             !print_trace(context, scene, point);
    if (!ok)
        fprintf(stderr, "%s\n", context ? graze_context_message(context) : "out of memory");
    graze_scene_destroy(scene);
    graze_motion_destroy(motion);
    graze_solid_destroy(solid);
    graze_context_destroy(context);
    mpq_clears(point[0], point[1], point[2], NULL);
    return ok ? 0 : 1;
}
