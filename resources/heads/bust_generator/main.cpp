// Makes the built-in head: hairpaint_bust_generator OUTPUT_DIR [--preview DIR]
//
// Writes bust-1.glb (roots, uv, picking) and bust-1-fine.glb (shading), and prints what the tests will measure.
#include <cstdio>
#include <filesystem>
#include <string_view>

#include "../bust_landmarks.h"
#include "bust_mesh.h"
#include "glb_writer.h"
#include "grid_relaxer.h"
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
    if (argc != 2 && !(argc == 4 && std::string_view(argv[2]) == "--preview")) {
        std::fputs("usage: hairpaint_bust_generator OUTPUT_DIR [--preview DIR]\n", stderr);
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    const PolarGrid fineGrid = bustGrid();
    const PolarGrid grid = coarsened(fineGrid);
    HalfMesh carrying = halfMesh(grid);
    HalfMesh fine = halfMesh(fineGrid);
    const UvReport report = layOutBust(grid, carrying);
    fine.uvs = interpolatedUvs(fine, carrying, grid.columns(), grid.rings());
    const Mesh carryingMesh = mirroredMesh(carrying);
    const Mesh fineMesh = mirroredMesh(fine);
    print("bust-1", carrying, carryingMesh);
    print("bust-1-fine", fine, fineMesh);
    std::printf("scalp: area scale %.2f (99 %%: %.2f), stretch %.2f (99 %%: %.2f), share %.1f %%, energy %.6g\n",
                report.scalpAreaRatio, report.scalpAreaRatio99, report.scalpStretch, report.scalpStretch99,
                100.0 * report.scalpShare, report.energy);
    if (argc == 4)
        writePreviews(fineMesh, carryingMesh, regionTint, argv[3]);
    if (!writeGlb(carryingMesh, folder / "bust-1.glb") || !writeGlb(fineMesh, folder / "bust-1-fine.glb")) {
        std::fprintf(stderr, "hairpaint_bust_generator: cannot write to %s\n", folder.string().c_str());
        return 1;
    }
    return 0;
}
