// Makes bust-2: hairpaint_bust_generator OUTPUT_DIR [--preview DIR | --colliders]
//
// Writes bust-2.glb (roots, uv, picking), bust-2.displacement (of its edges' middles, for the finer mesh that is drawn)
// and bust-2.marks (of the finer mesh's vertices), bust-2.distances (to the finer mesh), bust-2.stream (how hair grows
// at the coarser one's vertices), and prints what the tests will measure.
// --colliders instead fits the ellipsoids anew, from those in use, and prints them.
#include <cstdio>
#include <filesystem>
#include <string_view>

#include "bust_mesh.h"
#include "collider_fit.h"
#include "distance_writer.h"
#include "edge_displacement.h"
#include "glb_writer.h"
#include "grid_relaxer.h"
#include "model/heads/built_in_heads.h"
#include "preview.h"
#include "sim/skin/mesh_subdivision.h"
#include "sim/skin/natural_stream.h"
#include "skin_marks.h"
#include "stream_writer.h"
#include "uv_solver.h"

namespace {

using namespace hairpaint;
using namespace hairpaint::heads;

void print(const HalfMesh& half, const sim::HeadMesh& mesh)
{
    const MeshReport report = inspected(half);
    std::printf("%zu vertices, %zu triangles, aspect %.2f, least agreement %.3f, folded %d\n", mesh.positionsHd.size(),
                mesh.triangles.size(), static_cast<double>(report.worstAspect),
                static_cast<double>(report.worstAgreement), report.foldedFaces);
}

// As lines of bust_2.cpp.
void printColliders(const HalfMesh& half)
{
    const std::vector<sim::Ellipsoid> fitted = fittedColliders(half, bust2().colliders);
    const auto print = [](float value, const char* after) {
        std::printf("%.5fF%s", static_cast<double>(value), after);
    };
    for (const sim::Ellipsoid& e : fitted) {
        std::printf("    {{");
        for (int i = 0; i < 3; ++i)
            print(e.centreHd[i], i < 2 ? ", " : "}, {");
        for (int i = 0; i < 3; ++i)
            print(e.semiAxesM[i], i < 2 ? ", " : "}, {");
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
    if (bust2().regions.scalpDistance(p) > 0.0F)
        return {0.35F, 0.22F, 0.12F};
    if (bust2().regions.browDistance(p) > 0.0F)
        return {0.15F, 0.10F, 0.08F};
    if (bust2().regions.beardDistance(p) > 0.0F)
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
    const sim::HeadMesh mesh = mirroredMesh(carrying);
    const std::vector<std::int16_t> displacements = edgeDisplacements(mesh);
    print(carrying, mesh);
    std::printf("scalp: area scale %.2f (99 %%: %.2f), stretch %.2f (99 %%: %.2f), share %.1f %%, energy %.6g\n",
                report.scalpAreaRatio, report.scalpAreaRatio99, report.scalpStretch, report.scalpStretch99,
                100.0 * report.scalpFraction, report.energy);
    std::vector<float> metres;
    metres.reserve(displacements.size());
    for (const std::int16_t micrometres : displacements)
        metres.push_back(1.0e-6F * static_cast<float>(micrometres));
    const sim::HeadMesh fine = sim::subdivided(mesh, metres);
    if (option == "--preview")
        writePreviews(fine, mesh, regionTint, argv[3]);
    if (!writeGlb(mesh, folder / "bust-2.glb") || !writeDisplacements(displacements, folder / "bust-2.displacement") ||
        !writeMarks(skinMarks(fine), folder / "bust-2.marks") ||
        !writeDistances(*sim::DistanceGrid::make(fine), folder / "bust-2.distances") ||
        !writeStream(sim::naturalStream(sim::Skin(mesh), bust2().landmarks), folder / "bust-2.stream")) {
        std::fprintf(stderr, "hairpaint_bust_generator: cannot write to %s\n", folder.string().c_str());
        return 1;
    }
    return 0;
}
