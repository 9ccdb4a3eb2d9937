// The shading and the edges of a head that the paint area draws.
#pragma once

#include "model/project/project.h"
#include "view/paint_area/uv_wireframe.h"

#include <QImage>

#include <functional>
#include <memory>

class QObject;

namespace hairpaint::view {

struct HeadBackdrop
{
    QImage shading; ///< See bakeUvShading().
    UvWireframe wireframe;
};
using BackdropPtr = std::shared_ptr<const HeadBackdrop>;

/// Takes some 100 ms for the built-in head, and more for finer ones, at the first call; it is kept as long as the head
/// lives. From any thread. The head has a skin.
[[nodiscard]] BackdropPtr headBackdrop(const std::shared_ptr<const model::Head>& head);

/// Has `make` run, which takes a while, and tells `done` on the caller's thread, unless `receiver` is gone by then; of
/// null where `make` threw.
using StartBackdrop = std::function<void(const std::function<BackdropPtr()>& make, QObject* receiver,
                                         const std::function<void(const BackdropPtr&)>& done)>;

} // namespace hairpaint::view
