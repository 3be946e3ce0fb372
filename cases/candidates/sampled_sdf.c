/* sampled_sdf N SOLID MOTION POINTS OUT: the least signed distance at N evenly spread times.
 * SPDX-License-Identifier: CC0-1.0
 *
 * Negative where a ray from the point meets the boundary an odd number of times. Everything is double. Distances are
 * those of the solid's own space: for rigid motions alone.
 */
#include <math.h>
#include <stdlib.h>
#include "scene.h"

static double signed_distance(const scene *s, const double c[3]) {
    double least = INFINITY;
    for (int k = 0; k < s->facets; k++)
        least = fmin(least, scene_distance(s, &s->facet[k], c));
    return scene_inside(s, c) ? -least : least;
}

int main(int argc, char **argv) {
    if (argc != 6 || atoi(argv[1]) < 2) {
        fputs("usage: sampled_sdf N SOLID MOTION POINTS OUT, expected N of at least 2\n", stderr);
        return 2;
    }
    int count = atoi(argv[1]);
    scene s;
    points in;
    scene_read(&s, argv[2], argv[3]);
    points_open(&in, argv[4], s.dimension);
    FILE *out = open_for_writing(argv[5]);
    inverse *all = scene_sample(&s, count - 1);
    fputs(s.dimension == 2 ? "x,y,sdf\n" : "x,y,z,sdf\n", out);
    for (double p[3]; points_next(&in, p);) {
        double least = INFINITY;
        for (int k = 0; k < count; k++) {
            double c[3];
            scene_pull_back(c, (const double(*)[4])all[k], p);
            least = fmin(least, signed_distance(&s, c));
        }
        points_echo(&in, out);
        fprintf(out, "%.17g\n", least);
    }
    free(all);
    return fclose(out) == 0 ? 0 : 1;
}
