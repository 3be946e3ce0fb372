/* Shared by the programs that Graze is measured against: CPU time, raw doubles, counted hits.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_BENCH_PEER_H
#define TESTS_BENCH_PEER_H

#include <cstdint>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <istream>
#include <stdexcept>
#include <string>
#include <vector>

inline double seconds() {
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/* Records `from` to `from + n` of a file of doubles; the whole file if n is 0. */
inline std::vector<double> read_doubles(const std::string &path, size_t width, size_t from,
                                        size_t n) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    size_t records = file ? size_t(file.tellg()) / (width * sizeof(double)) : 0;
    n = n ? n : records;
    if (!file || from + n > records)
        throw std::runtime_error(path + ": too short");
    std::vector<double> data(n * width);
    file.seekg(std::streamoff(from * width * sizeof(double)));
    file.read(reinterpret_cast<char *>(data.data()), std::streamsize(n * width * sizeof(double)));
    return data;
}

/* Answer `count` or, with `keep`, `counts` by hits(segment), the number of a segment's hits. */
template <typename Hits> void count_hits(std::istream &command, bool keep, Hits hits_of) {
    std::string path, out;
    size_t from = 0, n = 0;
    command >> path >> from >> n >> out;
    std::vector<double> data = read_doubles(path, 6, from, n);
    std::vector<int64_t> hits(n);
    double start = seconds();
    for (size_t k = 0; k < n; k++)
        hits[k] = int64_t(hits_of(&data[6 * k]));
    double spent = seconds() - start;
    size_t hit = 0, all = 0;
    for (int64_t h : hits) {
        hit += h > 0;
        all += size_t(h);
    }
    if (keep)
        std::ofstream(out, std::ios::binary)
            .write(reinterpret_cast<const char *>(hits.data()), std::streamsize(n * 8));
    std::printf("seconds=%.9f hit=%zu hits=%zu\n", spent, hit, all);
}

/* A peer's main: serve(MESH) answers; its exception is told. */
inline int peer_main(int count, char **arguments, void (*serve)(const char *path)) {
    if (count != 2)
        return 2;
    try {
        serve(arguments[1]);
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s: %s\n", arguments[0], error.what());
        return 1;
    }
    return 0;
}

#endif
