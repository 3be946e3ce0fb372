/* Bullet's first contact of a convex solid that moves with one that stands: conservative
 * advancement of btContinuousConvexCollision, with GJK and EPA, in double precision.
 * SPDX-License-Identifier: CC0-1.0
 *
 * Usage: bullet hull|box MOVING FIXED [RADIUS]. Solids are OFF: `hull` takes the convex hull of the
 * vertices without a margin, `box` their box as btBoxShape with Bullet's own margin. With RADIUS,
 * MOVING is an OFF of one vertex or two, of a ball or of a capsule about them. Answers one line
 * `key=value ...` when both are loaded, then one for each line of standard input:
 *   advance N MOTION    N parts of the motion, each given by its end poses
 *   distance N MOTION   the least distance at N evenly spread times, as `distance`, by GJK
 * as fcl.cpp does. A motion is rigid and starts and ends within doubles.
 *
 *   c++ -std=c++17 -O2 $(pkg-config --cflags bullet-float64) bullet.cpp scene.o motion.o
 *       -lBulletCollision-float64 -lLinearMath-float64 -lyajl -lm
 */
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>
#include <vector>
extern "C" {
#define inverse scene_rows /* Bullet has a function of this name */
#include "scene.h"
#undef inverse
}
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <btBulletCollisionCommon.h>

struct body {
    std::unique_ptr<btConvexShape> shape;
    btTransform place = btTransform::getIdentity(); /* of the shape in the solid */
};

[[noreturn]] static void refuse(const char *what) {
    std::fprintf(stderr, "bullet: %s\n", what);
    std::exit(2);
}

static double seconds() {
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

static btVector3 vertex_of(const scene &s, int k) {
    return {s.vertex[k][0], s.vertex[k][1], s.vertex[k][2]};
}

static body hull_of(const scene &s) {
    auto hull = std::make_unique<btConvexHullShape>();
    for (int k = 0; k < s.vertices; k++)
        hull->addPoint(vertex_of(s, k), false);
    hull->recalcLocalAabb();
    hull->setMargin(0);
    return {std::move(hull)};
}

static body box_of(const scene &s) {
    btVector3 low = vertex_of(s, 0), high = low;
    for (int k = 1; k < s.vertices; k++) {
        low.setMin(vertex_of(s, k));
        high.setMax(vertex_of(s, k));
    }
    body b{std::make_unique<btBoxShape>((high - low) / 2)};
    b.place.setOrigin((low + high) / 2);
    return b;
}

static body round_of(const scene &s, double radius) {
    if (s.vertices != 1 && s.vertices != 2)
        refuse("expected one vertex, of a ball, or two, of a capsule");
    btVector3 from = vertex_of(s, 0), to = vertex_of(s, s.vertices - 1);
    body b;
    b.place.setOrigin((from + to) / 2);
    if (s.vertices == 1) {
        b.shape = std::make_unique<btSphereShape>(radius);
        return b;
    }
    b.shape = std::make_unique<btCapsuleShapeZ>(radius, (to - from).length());
    b.place.setRotation(shortestArcQuat(btVector3(0, 0, 1), (to - from).normalized()));
    return b;
}

/* M(t) at N + 1 times. */
static std::vector<btTransform> poses_of(const scene &s, int parts) {
    std::vector<btTransform> out;
    scene_rows *all = scene_sample(&s, parts);
    for (int k = 0; k <= parts; k++) {
        const auto &row = all[k];
        btTransform back(btMatrix3x3(row[0][0], row[0][1], row[0][2], row[1][0], row[1][1],
                                     row[1][2], row[2][0], row[2][1], row[2][2]),
                         btVector3(row[0][3], row[1][3], row[2][3]));
        out.push_back(back.inverse());
    }
    std::free(all);
    return out;
}

/* From 0 to 1, or -1 without a contact. */
static double advance(const body &a, const body &b, const std::vector<btTransform> &poses) {
    size_t parts = poses.size() - 1;
    for (size_t k = 0; k < parts; k++) {
        btVoronoiSimplexSolver simplex;
        btGjkEpaPenetrationDepthSolver depth;
        btContinuousConvexCollision test(a.shape.get(), b.shape.get(), &simplex, &depth);
        btConvexCast::CastResult result;
        if (test.calcTimeOfImpact(poses[k] * a.place, poses[k + 1] * a.place, b.place, b.place,
                                  result))
            return (double(k) + result.m_fraction) / double(parts);
    }
    return -1;
}

static double nearest(const body &a, const body &b, const std::vector<btTransform> &poses) {
    double least = HUGE_VAL;
    for (const btTransform &pose : poses) {
        btVoronoiSimplexSolver simplex;
        btGjkEpaPenetrationDepthSolver depth;
        btGjkPairDetector test(a.shape.get(), b.shape.get(), &simplex, &depth);
        btGjkPairDetector::ClosestPointInput input;
        btPointCollector found;
        input.m_transformA = pose * a.place;
        input.m_transformB = b.place;
        test.getClosestPoints(input, found, nullptr);
        if (found.m_hasResult)
            least = std::min(least, double(found.m_distance));
    }
    return least;
}

int main(int argc, char **argv) {
    if ((argc != 4 && argc != 5) ||
        (std::strcmp(argv[1], "hull") != 0 && std::strcmp(argv[1], "box") != 0))
        refuse("expected hull or box, MOVING, FIXED and perhaps RADIUS");
    scene solids[2]; /* the first one takes the motions */
    body bodies[2];
    double start = seconds();
    for (int k = 0; k < 2; k++) {
        scene_read_solid(&solids[k], argv[2 + k]);
        bool round = argc == 5 && k == 0;
        bodies[k] = round             ? round_of(solids[k], std::atof(argv[4]))
                    : *argv[1] == 'h' ? hull_of(solids[k])
                                      : box_of(solids[k]);
    }
    std::printf("loaded=%.9f\n", seconds() - start);
    std::fflush(stdout);
    char line[4096], motion[4000], method[16];
    int n;
    while (std::fgets(line, sizeof line, stdin)) {
        scene &s = solids[0];
        if (std::sscanf(line, "%15s %d %3999s", method, &n, motion) != 3 || n < 1 || n > 1000000 ||
            (std::strcmp(method, "advance") != 0 && std::strcmp(method, "distance") != 0))
            refuse("expected advance N MOTION or distance N MOTION, N at least 1");
        scene_read_motion(&s, motion);
        bool measures = *method == 'd';
        std::vector<btTransform> poses = poses_of(s, measures ? std::max(n - 1, 1) : n);
        start = seconds();
        if (measures) {
            double least = nearest(bodies[0], bodies[1], poses);
            std::printf("distance=%.17g seconds=%.9f\n", least, seconds() - start);
            std::fflush(stdout);
            continue;
        }
        double share = advance(bodies[0], bodies[1], poses), spent = seconds() - start;
        double from = s.piece[0].from, to = s.piece[s.pieces - 1].to;
        std::printf("hit=%d t=%.17g seconds=%.9f\n", share >= 0,
                    from + (to - from) * (share < 0 ? 0 : share), spent);
        std::fflush(stdout);
    }
    return 0;
}
