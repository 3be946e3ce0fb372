/* Writes the solid of some shells (shells.h, standard input) as a .nef3 file to standard output.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "shells.h"
#include <CGAL/IO/Nef_polyhedron_iostream_3.h>
#include <iostream>

int main() {
    try {
        Nef solid = read_solid(std::cin);
        std::cout << solid;
    } catch (const std::exception &error) {
        std::cerr << "to_nef: " << error.what() << "\n";
        return 1;
    }
    return std::cout.flush() ? 0 : 1;
}
