// The real window with long hair on the head: where it hangs over skin, and brushes over it.
#pragma once

#include "model/files/preset_file.h"
#include "model/styles/preset.h"
#include "tests/app/window_fixture.h"
#include "view/picking/hair_picture.h"

#include <algorithm>

namespace hairpaint::app {

using model::MapKind;
using model::TouchKind;

class LongHairFixture : protected WindowFixture
{
protected:
    QPoint m_at; ///< A point of the 3D area, px, where hair hangs over skin, far from its roots.
    QWidget* m_head = nullptr;

    void openWithLongHair()
    {
        model::Project project = model::newProject();
        const auto preset = model::loadPreset(QStringLiteral(":/presets/long-straight.hairpreset"));
        QVERIFY(preset.has_value());
        model::applyPreset(project, *preset);
        openWindow(std::move(project));
        awaitNewestHair();
        awaitFinePicture();
        m_head = &m_window->headView();
        const auto seen = seenHair();
        m_at = {};
        for (int y = m_head->height() / 3; y < m_head->height() && m_at.isNull(); y += 6)
            for (int x = 20; x < m_head->width() - 20 && m_at.isNull(); x += 6)
                if (hangsAt(*seen, {x, y}) && hangsAt(*seen, {x, y + 20}))
                    m_at = {x, y};
        QVERIFY(!m_at.isNull());
    }
    [[nodiscard]] std::shared_ptr<const view::HairPicture> seenHair()
    {
        const view::HeadView& head = m_window->headView();
        return std::make_shared<const view::HairPicture>(
            view::PictureSource{.frame = session().frame(),
                                .group = editor().target().group(),
                                .camera = head.camera(),
                                .size = head.size(),
                                .skin = session().document().project().head->skin});
    }
    [[nodiscard]] bool hangsAt(const view::HairPicture& seen, QPoint at)
    {
        constexpr float kFarM = 0.06F;
        const auto skin = m_window->headView().skinAt(at);
        const auto strands = seen.under(at, 4.0);
        return skin && strands.size() > 2 && std::ranges::all_of(strands, [&](const model::SeenStrand& one) {
                   return glm::distance(one.rootHd, skin->positionHd) > kFarM;
               });
    }
    void setTools(model::ToolId tool, TouchKind touch)
    {
        editor().tools().choose(tool);
        model::ToolSettings settings = editor().tools().settings();
        settings.touch = touch;
        settings.brushSizeM = 0.01F;
        settings.hardness = 1.0F;
        settings.value(MapKind::Colour).colour = QColor(255, 0, 0);
        editor().tools().setSettings(settings);
    }
    [[nodiscard]] std::shared_ptr<const sim::TiledRaster> map(MapKind kind)
    {
        return session().document().resolvedNow(editor().target().group(), kind);
    }
    [[nodiscard]] std::vector<QPoint> differing(const sim::TiledRaster& a, const sim::TiledRaster& b)
    {
        std::vector<QPoint> texels;
        for (int y = 0; y < a.size(); ++y)
            for (int x = 0; x < a.size(); ++x)
                if (a.texel(x, y) != b.texel(x, y))
                    texels.emplace_back(x, y);
        return texels;
    }
    /// A point of the 3D area, px, where hair grows on the skin.
    [[nodiscard]] QPoint hairyPoint()
    {
        const auto density = map(MapKind::Density);
        for (int y = 20; y < m_head->height(); y += 6)
            for (int x = 20; x < m_head->width() - 20; x += 6) {
                const auto isHairy = [&](QPoint at) {
                    const auto skin = m_window->headView().skinAt(at);
                    return skin && density->sampleScalar(skin->uv) > 0.5F && std::abs(skin->positionHd.x) > 0.03F;
                };
                if (isHairy({x, y}) && isHairy({x, y + 20}))
                    return {x, y};
            }
        return {};
    }
    [[nodiscard]] static glm::vec2 otherSide(glm::vec2 uv) { return {1.0F - uv.x, uv.y}; }
    void strokeTo(QPoint to, bool release = true)
    {
        QTest::mouseMove(m_head, m_at);
        QTest::mousePress(m_head, Qt::LeftButton, {}, m_at);
        for (int i = 1; i <= 5; ++i)
            QTest::mouseMove(m_head, m_at + (to - m_at) * i / 5);
        if (release)
            QTest::mouseRelease(m_head, Qt::LeftButton, {}, to);
    }
};

} // namespace hairpaint::app
