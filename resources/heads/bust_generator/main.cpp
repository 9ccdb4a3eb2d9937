// Makes the built-in head: hairpaint_bust_generator OUTPUT_DIR [--preview DIR | --colliders]
//
// Writes bust-1.glb (roots, uv, picking) and bust-1-fine.glb (shading), and prints what the tests will measure.
// --colliders instead fits the ellipsoids anew, from those in use, and prints them.
#include <cstdio>
#include <filesystem>
#include <string_view>

#include "bust_mesh.h"
#include "collider_fit.h"
#include "glb_writer.h"
#include "grid_relaxer.h"
#include "model/heads/bust_landmarks.h"
#include "preview.h"
#include "uv_solver.h"

namespace {

using namespace hairpaint::heads;

void print(const char* name, const HalfMesh& half, const Mesh& mesh)
{
    const MeshReport report = inspected(half);
    std::printf("%s: %zu vertices, %zu triangles, aspect %.2f, least agreement %.3f, folded %d\n", name,
                mesh.positions.size(), mesh.triangles.size(), static_cast<double>(report.worstAspect),
                static_cast<double>(report.worstAgreement), report.foldedFaces);
}

// As lines of bust_colliders.cpp.
void printColliders(const HalfMesh& half)
{
    const std::vector<EllipsoidSpec> fitted = fittedColliders(half, bustColliders());
    const auto print = [](float value, const char* after) {
        std::printf("%.5fF%s", static_cast<double>(value), after);
    };
    for (const EllipsoidSpec& e : fitted) {
        std::printf("    {{");
        for (int i = 0; i < 3; ++i)
            print(e.centre[i], i < 2 ? ", " : "}, {");
        for (int i = 0; i < 3; ++i)
            print(e.semiAxes[i], i < 2 ? ", " : "}, {");
        for (const float value : {e.rotation.w, e.rotation.x, e.rotation.y})
            print(value, ", ");
        print(e.rotation.z, "}},\n");
    }
    const ColliderReport report = inspected(half, fitted);
    std::printf("scalp %.2f mm outside, union %.2f mm outside the scalp, elsewhere within %.1f mm\n",
                1000.0 * static_cast<double>(report.scalpOutside), 1000.0 * static_cast<double>(report.scalpInside),
                1000.0 * static_cast<double>(report.elsewhere));
}

glm::vec3 regionTint(const glm::vec3& p)
{
    if (scalpDistance(p) > 0.0F)
        return {0.35F, 0.22F, 0.12F};
    if (browDistance(p) > 0.0F)
        return {0.15F, 0.10F, 0.08F};
    if (beardDistance(p) > 0.0F)
        return {0.55F, 0.35F, 0.22F};
    return {0.75F, 0.65F, 0.58F};
}

} // namespace

int main(int argc, char** argv)
{
    const std::string_view option = argc > 2 ? argv[2] : "";
    if (argc != 2 && !(argc == 3 && option == "--colliders") && !(argc == 4 && option == "--preview")) {
        std::fputs("usage: hairpaint_bust_generator OUTPUT_DIR [--preview DIR | --colliders]\n", stderr);
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    const PolarGrid fineGrid = bustGrid();
    const PolarGrid grid = coarsened(fineGrid);
    HalfMesh carrying = halfVertices(grid);
    addTriangles(carrying, grid);
    if (option == "--colliders") {
        printColliders(carrying);
        return 0;
    }
    const UvReport report = layOutBust(grid, carrying);
    HalfMesh fine = halfVertices(fineGrid);
    fine.uvs = interpolatedUvs(fine, carrying, grid);
    addTriangles(fine, fineGrid);
    const Mesh carryingMesh = mirroredMesh(carrying);
    const Mesh fineMesh = mirroredMesh(fine);
    print("bust-1", carrying, carryingMesh);
    print("bust-1-fine", fine, fineMesh);
    std::printf("scalp: area scale %.2f (99 %%: %.2f), stretch %.2f (99 %%: %.2f), share %.1f %%, energy %.6g\n",
                report.scalpAreaRatio, report.scalpAreaRatio99, report.scalpStretch, report.scalpStretch99,
                100.0 * report.scalpShare, report.energy);
    if (option == "--preview")
        writePreviews(fineMesh, carryingMesh, regionTint, argv[3]);
    if (!writeGlb(carryingMesh, folder / "bust-1.glb") || !writeGlb(fineMesh, folder / "bust-1-fine.glb")) {
        std::fprintf(stderr, "hairpaint_bust_generator: cannot write to %s\n", folder.string().c_str());
        return 1;
    }
    return 0;
}
