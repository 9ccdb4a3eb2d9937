// Heads in files: a mesh that reads, with its skeleton, can be written and read again, and a small one becomes a head
// or is refused.
#include "model/files/glb.h"
#include "model/files/glb_writing.h"
#include "model/files/head_file.h"
#include "sim/skin/head_limits.h"
#include "tests/fuzz/fuzz_input.h"

using namespace hairpaint;

namespace {

/// Without a skeleton where that can't be read.
model::RiggedMesh rigged(const sim::HeadMesh& mesh, const model::Checked<model::HeadSkeleton>& skeleton)
{
    model::RiggedMesh whole(mesh);
    if (skeleton)
        whole.skeleton = *skeleton;
    return whole;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    constexpr std::size_t kMostFaces = 64;
    fuzz::Input input(data, size);
    const int choice = input.byte();
    const QByteArray glb = input.rest();
    const model::Checked<sim::HeadMesh> mesh = model::meshFromGlb(glb);
    if (!mesh)
        return 0;
    if (const model::Checked<model::GlbParts> parts = model::partsFromGlb(glb)) {
        fuzz::require(parts->parts.size() == parts->weights.size());
        for (const model::HeadPart& part : parts->parts)
            fuzz::require(part.mesh != nullptr && sim::withinLimits(*part.mesh));
    }
    const QByteArray written = model::glbFromMesh(rigged(*mesh, model::skeletonFromGlb(glb)));
    const model::Checked<sim::HeadMesh> again = model::meshFromGlb(written);
    const model::Checked<model::HeadSkeleton> skeleton = model::skeletonFromGlb(written);
    fuzz::require(again && skeleton && model::glbFromMesh(rigged(*again, skeleton)) == written);
    if (choice % 8 != 0 || mesh->triangles.size() > kMostFaces)
        return 0;
    const model::UpAxis axis = choice % 16 == 0 ? model::UpAxis::Y : model::UpAxis::Z;
    if (const auto head = model::makeHead(QStringLiteral("fuzz"), glb, 1.0F, axis))
        fuzz::require((*head)->skin != nullptr && (*head)->skin->areaM2() > 0.0);
    return 0;
}
