// Heads in files: a mesh that reads can be written and read again, and a small one becomes a head or is refused.
#include "model/files/glb.h"
#include "model/files/head_file.h"
#include "tests/fuzz/fuzz_input.h"

using namespace hairpaint;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    constexpr std::size_t kMostFaces = 64;
    fuzz::Input input(data, size);
    const int choice = input.byte();
    const QByteArray glb = input.rest();
    const model::Checked<sim::HeadMesh> mesh = model::meshFromGlb(glb);
    if (!mesh)
        return 0;
    const QByteArray written = model::glbFromMesh(*mesh);
    const model::Checked<sim::HeadMesh> again = model::meshFromGlb(written);
    fuzz::require(again && model::glbFromMesh(*again) == written);
    if (choice % 8 != 0 || mesh->triangles.size() > kMostFaces)
        return 0;
    const model::UpAxis axis = choice % 16 == 0 ? model::UpAxis::Y : model::UpAxis::Z;
    if (const auto head = model::makeHead(QStringLiteral("fuzz"), glb, 1.0F, axis))
        fuzz::require((*head)->skin != nullptr && (*head)->skin->areaM2() > 0.0);
    return 0;
}
