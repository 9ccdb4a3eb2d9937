// Bakes a head's light and shade, and its edges.
#include "view/paint_area/head_backdrop.h"

#include "sim/base/kept_with.h"
#include "view/paint_area/uv_shading.h"

namespace hairpaint::view {

namespace {

BackdropPtr bakedBackdrop(const model::Head& head)
{
    constexpr int kShadingSide = 512;
    const sim::HeadMesh& coarse = head.skin->mesh();
    const bool hasShown = head.shownMesh && head.shownMesh->uvs.size() == head.shownMesh->positionsHd.size();
    return std::make_shared<HeadBackdrop>(HeadBackdrop{
        .shading = bakeUvShading(hasShown ? *head.shownMesh : coarse, kShadingSide), .wireframe = UvWireframe(coarse)});
}

} // namespace

BackdropPtr headBackdrop(const std::shared_ptr<const model::Head>& head)
{
    static sim::KeptWith<model::Head, HeadBackdrop> backdrops;
    return backdrops.of(head, [](const model::Head& of) { return bakedBackdrop(of); });
}

} // namespace hairpaint::view
