/* The peer in single precision: hits of segments with a mesh by Intel's Embree (Wald et al. 2014),
 * robust, all hits of a segment by a filter that refuses each. SPDX-License-Identifier:
 * GPL-3.0-or-later
 *
 * Usage: embree MESH.off. Answers one line `key=value ...` when the mesh is loaded, then one a line
 * of standard input: count and counts, as peers.cpp has them. Coordinates are rounded to single
 * precision.
 */
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <iostream>
#include <sstream>
#include "peer.h"

namespace {

size_t found; // hits of the segment at hand

void refuse(const RTCFilterFunctionNArguments *hit) {
    found++;
    hit->valid[0] = 0;
}

template <typename Number>
Number *buffer(RTCGeometry mesh, RTCBufferType type, RTCFormat format, size_t count) {
    void *made = rtcSetNewGeometryBuffer(mesh, type, 0, format, 3 * sizeof(Number), count);
    if (!made)
        throw std::runtime_error("Embree: no memory for a mesh");
    return static_cast<Number *>(made);
}

size_t read_mesh(RTCGeometry mesh, const char *path) {
    std::ifstream file(path);
    std::string magic;
    size_t vertices = 0, faces = 0, edges = 0, corners = 3;
    file >> magic >> vertices >> faces >> edges;
    if (!file)
        throw std::runtime_error(std::string(path) + ": cannot be read");
    float *point = buffer<float>(mesh, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, vertices);
    for (size_t k = 0; k < 3 * vertices; k++)
        file >> point[k];
    auto *corner = buffer<unsigned>(mesh, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, faces);
    for (size_t k = 0; k < faces && corners == 3; k++)
        file >> corners >> corner[3 * k] >> corner[3 * k + 1] >> corner[3 * k + 2];
    if (!file || magic != "OFF" || corners != 3)
        throw std::runtime_error(std::string(path) + ": expected an OFF file of triangles");
    return faces;
}

size_t hits_of(RTCScene scene, const double *x) {
    RTCRay ray = {};
    ray.org_x = float(x[0]), ray.org_y = float(x[1]), ray.org_z = float(x[2]);
    ray.dir_x = float(x[3] - x[0]), ray.dir_y = float(x[4] - x[1]), ray.dir_z = float(x[5] - x[2]);
    ray.tfar = 1;
    ray.mask = unsigned(-1);
    found = 0;
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(scene, &ray, nullptr);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
#endif
    return found;
}

void serve(const char *path) {
    RTCDevice device = rtcNewDevice("threads=1");
    RTCScene scene = rtcNewScene(device);
    RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    size_t faces = read_mesh(mesh, path);
    double start = seconds();
    rtcSetGeometryOccludedFilterFunction(mesh, refuse);
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene, mesh);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    rtcCommitScene(scene);
    std::printf("faces=%zu tree=%.9f version=%d\n", faces, seconds() - start, RTC_VERSION);
    std::fflush(stdout);
    for (std::string line; std::getline(std::cin, line); std::fflush(stdout)) {
        std::istringstream command(line);
        std::string verb;
        command >> verb;
        if (verb != "count" && verb != "counts")
            throw std::runtime_error("unknown command: " + line);
        count_hits(command, verb == "counts",
                   [scene](const double *x) { return hits_of(scene, x); });
    }
    rtcReleaseGeometry(mesh);
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
}

} // namespace

int main(int count, char **arguments) {
    return peer_main(count, arguments, serve);
}
