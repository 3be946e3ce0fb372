/* sampled N SOLID MOTION POINTS OUT: in the sweep if in the solid at one of N + 1 times.
 * SPDX-License-Identifier: CC0-1.0
 *
 * The times are spread evenly over the motion. A point is in the solid if a ray from it meets the
 * boundary an odd number of times. Everything is double; the answer is in or out.
 */
#include <stdlib.h>
#include "scene.h"

int main(int argc, char **argv) {
    if (argc != 6 || atoi(argv[1]) < 1) {
        fputs("usage: sampled N SOLID MOTION POINTS OUT\n", stderr);
        return 2;
    }
    int count = atoi(argv[1]);
    scene s;
    points in;
    scene_read(&s, argv[2], argv[3]);
    points_open(&in, argv[4], s.dimension);
    FILE *out = open_for_writing(argv[5]);
    inverse *all = scene_sample(&s, count);
    fputs(s.dimension == 2 ? "x,y,pmc\n" : "x,y,z,pmc\n", out);
    for (double p[3]; points_next(&in, p);) {
        int inside = 0;
        for (int k = 0; k <= count && !inside; k++) {
            double c[3];
            scene_pull_back(c, (const double(*)[4])all[k], p);
            inside = scene_inside(&s, c);
        }
        points_echo(&in, out);
        fputs(inside ? "in\n" : "out\n", out);
    }
    return fclose(out) == 0 ? 0 : 1;
}
