/* FCL's first contact of a solid that moves with one that stands: continuous collision by
 * conservative advancement, and its discrete test at evenly spread times.
 * SPDX-License-Identifier: CC0-1.0
 *
 * Usage: fcl mesh|box MOVING FIXED [RADIUS]. Solids are OFF of triangles; `box` takes the box of
 * each one's vertices as FCL's shape instead. With RADIUS, MOVING is an OFF of one vertex or
 * two, of a ball or of a capsule about them. Answers one line `key=value ...` when both are
 * loaded, then one for each line of standard input:
 *   discrete N MOTION   collide at N evenly spread times, the first that says yes
 *   every N MOTION      the same, and no time is left out after that
 *   distance N MOTION   the least distance at N evenly spread times, as `distance`
 *   advance N MOTION    continuousCollide of N parts of the motion, each given by its end poses
 * A motion is rigid and starts and ends within doubles. `hit` is 0 or 1, `t` the time of contact,
 * `seconds` the CPU time without reading anything; `loaded` is that of building FCL's models.
 *
 *   c++ -std=c++17 -O2 -DNDEBUG -I/usr/include/eigen3 fcl.cpp scene.o motion.o -lfcl -lccd -lyajl -lm
 */
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>
#include <string>
#include <vector>
extern "C" {
#include "scene.h"
}
#include <fcl/fcl.h>

using Pose = fcl::Transform3d;
using Model = fcl::BVHModel<fcl::OBBRSSd>;

struct body {
    std::shared_ptr<fcl::CollisionGeometryd> shape;
    Pose place = Pose::Identity(); /* of the shape in the solid */
};

struct contact {
    bool hit;
    double at; /* from 0 to 1 */
};

static double seconds() {
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

[[noreturn]] static void refuse(const char *what) {
    std::fprintf(stderr, "fcl: %s\n", what);
    std::exit(2);
}

static body mesh_of(const scene &s) {
    auto model = std::make_shared<Model>();
    model->beginModel(s.facets, s.vertices);
    std::vector<fcl::Vector3d> points;
    std::vector<fcl::Triangle> triangles;
    for (int k = 0; k < s.vertices; k++)
        points.emplace_back(s.vertex[k][0], s.vertex[k][1], s.vertex[k][2]);
    for (int k = 0; k < s.facets; k++) {
        const int *v = s.facet[k].vertex;
        if (s.facet[k].count != 3)
            refuse("expected triangles: graze convert SOLID -o FILE.off");
        triangles.emplace_back(v[0], v[1], v[2]);
    }
    model->addSubModel(points, triangles);
    model->endModel();
    return {model};
}

static body box_of(const scene &s) {
    Eigen::AlignedBox3d box;
    for (int k = 0; k < s.vertices; k++)
        box.extend(Eigen::Vector3d(s.vertex[k][0], s.vertex[k][1], s.vertex[k][2]));
    body b{std::make_shared<fcl::Boxd>(fcl::Vector3d(box.sizes()))};
    b.place.translation() = box.center();
    return b;
}

static body round_of(const scene &s, double radius) {
    if (s.vertices != 1 && s.vertices != 2)
        refuse("expected one vertex, of a ball, or two, of a capsule");
    Eigen::Vector3d from(s.vertex[0]), to(s.vertex[s.vertices - 1]);
    body b;
    if (s.vertices == 1)
        b.shape = std::make_shared<fcl::Sphered>(radius);
    else
        b.shape = std::make_shared<fcl::Capsuled>(radius, (to - from).norm());
    b.place.translation() = (from + to) / 2;
    if (s.vertices == 2)
        b.place.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), to - from)
                               .toRotationMatrix();
    return b;
}

static std::vector<Pose> poses_of(const scene &s, int count) {
    std::vector<Pose> out;
    inverse *all = scene_sample(&s, count - 1);
    for (int k = 0; k < count; k++) {
        Pose back = Pose::Identity();
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 4; j++)
                back(i, j) = all[k][i][j];
        if ((back.linear() * back.linear().transpose() - Eigen::Matrix3d::Identity()).norm() > 1e-9)
            refuse("expected a rigid motion");
        out.push_back(back.inverse(Eigen::Isometry));
    }
    std::free(all);
    return out;
}

/* An array of poses starts at 0 and ends at 1. */
static contact discrete(const body &a, const body &b, const std::vector<Pose> &poses, bool every) {
    contact found{false, 0};
    for (size_t k = 0; k < poses.size() && (every || !found.hit); k++) {
        fcl::CollisionRequestd request;
        fcl::CollisionResultd result;
        Pose moved = poses[k] * a.place;
        bool hit = fcl::collide(a.shape.get(), moved, b.shape.get(), b.place, request, result) > 0;
        if (hit && !found.hit)
            found = {true, double(k) / double(poses.size() - 1)};
    }
    return found;
}

static double nearest(const body &a, const body &b, const std::vector<Pose> &poses) {
    double least = HUGE_VAL;
    for (const Pose &pose : poses) {
        fcl::DistanceRequestd request;
        fcl::DistanceResultd result;
        Pose moved = pose * a.place;
        fcl::distance(a.shape.get(), moved, b.shape.get(), b.place, request, result);
        least = std::min(least, result.min_distance);
    }
    return least;
}

/* FCL's own requests, but for the kinds of motion and solver. */
static contact advance(const body &a, const body &b, const std::vector<Pose> &poses) {
    bool straight = true;
    for (const Pose &p : poses)
        straight = straight && p.linear().isApprox(poses[0].linear(), 1e-15);
    fcl::ContinuousCollisionRequestd request;
    request.ccd_motion_type = straight ? fcl::CCDM_TRANS : fcl::CCDM_LINEAR;
    request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    size_t parts = poses.size() - 1;
    for (size_t k = 0; k < parts; k++) {
        fcl::ContinuousCollisionResultd result;
        fcl::continuousCollide(a.shape.get(), poses[k] * a.place, poses[k + 1] * a.place,
                               b.shape.get(), b.place, b.place, request, result);
        if (result.is_collide)
            return {true, (double(k) + result.time_of_contact) / double(parts)};
    }
    return {false, 0};
}

static void answer(const body &a, const body &b, scene &s, const char *method, int n,
                   const char *motion) {
    contact found;
    scene_read_motion(&s, motion);
    bool advances = std::strcmp(method, "advance") == 0;
    std::vector<Pose> poses = poses_of(s, advances ? n + 1 : n);
    double start = seconds();
    if (std::strcmp(method, "distance") == 0) {
        double least = nearest(a, b, poses);
        std::printf("distance=%.17g seconds=%.9f\n", least, seconds() - start);
        return;
    }
    found = advances ? advance(a, b, poses) : discrete(a, b, poses, *method == 'e');
    double spent = seconds() - start, from = s.piece[0].from, to = s.piece[s.pieces - 1].to;
    std::printf("hit=%d t=%.17g seconds=%.9f\n", found.hit, from + (to - from) * found.at, spent);
}

int main(int argc, char **argv) {
    if ((argc != 4 && argc != 5) ||
        (std::strcmp(argv[1], "mesh") != 0 && std::strcmp(argv[1], "box") != 0))
        refuse("expected mesh or box, MOVING, FIXED and perhaps RADIUS");
    scene solids[2]; /* the first one takes the motions */
    body bodies[2];
    double loaded = 0;
    for (int k = 0; k < 2; k++) {
        scene_read_solid(&solids[k], argv[2 + k]);
        double start = seconds();
        bool round = argc == 5 && k == 0;
        bodies[k] = round             ? round_of(solids[k], std::atof(argv[4]))
                    : *argv[1] == 'm' ? mesh_of(solids[k])
                                      : box_of(solids[k]);
        loaded += seconds() - start;
    }
    std::printf("loaded=%.9f\n", loaded);
    std::fflush(stdout);
    char line[4096], method[16], motion[4000];
    int n;
    while (std::fgets(line, sizeof line, stdin)) {
        if (std::sscanf(line, "%15s %d %3999s", method, &n, motion) != 3 || n < 1 || n > 1000000)
            refuse("expected METHOD N MOTION, N at least 1");
        answer(bodies[0], bodies[1], solids[0], method, n, motion);
        std::fflush(stdout);
    }
    return 0;
}
