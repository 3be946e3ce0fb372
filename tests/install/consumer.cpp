/* The C++ program of someone who has Graze installed: a square moves past three points, and a ring
 * that crosses itself is refused. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <graze.h>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

template <class Handle> using owned = std::unique_ptr<Handle, void (*)(Handle *)>;

/* An exception of the program's own, which must still arrive after those inside the library. */
owned<graze_solid> ring(graze_context *context, const std::vector<double> &corners) {
    const std::size_t count = corners.size() / 2;
    std::vector<std::size_t> order(count);
    for (std::size_t k = 0; k < count; k++)
        order[k] = k;
    graze_solid *solid = nullptr;
    if (graze_solid_from_doubles(&solid, context, 2, corners.data(), count, &count, 1, order.data(),
                                 0) == GRAZE_EILLEGAL)
        throw std::domain_error("refused");
    return {solid, graze_solid_destroy};
}

} // namespace

int main() {
    graze_context *made = nullptr;
    if (graze_context_create(&made))
        return 1;
    const owned<graze_context> context(made, graze_context_destroy);
    const owned<graze_solid> solid = ring(made, {0, 0, 2, 0, 2, 2, 0, 2});
    const std::string text = R"({"dimension": 2, "pieces": [
        {"t": [0, 1], "transform": {"translate": ["8*t", 0]}}]})";
    graze_motion *motion = nullptr;
    graze_scene *scene = nullptr;
    graze_verdict verdicts[3] = {};
    const double points[] = {5, 1, 5, 2, 5, 3};
    if (graze_motion_from_json(&motion, made, text.data(), text.size()) ||
        graze_scene_create(&scene, made, solid.get(), motion, nullptr) ||
        graze_classify_doubles(verdicts, made, scene, points, 3, GRAZE_COLUMNS_ALL))
        std::cout << graze_context_message(made) << '\n';
    for (const graze_verdict &verdict : verdicts)
        std::cout << graze_pmc_name(verdict.pmc) << '\n';
    mpq_t point[2]; /* converts to graze_rationals as it is */
    mpq_inits(point[0], point[1], nullptr);
    if (graze_classify(verdicts, made, scene, point, 1, GRAZE_COLUMNS_ALL))
        std::cout << graze_context_message(made) << '\n';
    mpq_clears(point[0], point[1], nullptr);
    graze_scene_destroy(scene);
    graze_motion_destroy(motion);
    try {
        ring(made, {0, 0, 2, 2, 2, 0, 0, 2});
    } catch (const std::domain_error &error) {
        std::cout << error.what() << '\n';
    }
    return 0;
}
