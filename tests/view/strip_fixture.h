// A strip of styles that are made where they would be read, over a small project.
#pragma once

#include "model/document/layer_commands.h"
#include "model/document/paint_command.h"
#include "tests/support/patience.h"
#include "tests/view/panel_fixture.h"
#include "view/panels/style_question.h"
#include "view/panels/style_row.h"
#include "view/panels/style_strip.h"
#include "view/panels/style_tile.h"

#include <QCursor>
#include <QTimer>
#include <QWheelEvent>

#include <algorithm>

namespace hairpaint::view {

inline void paint(model::HairGroup& group, model::MapKind kind, std::uint16_t value)
{
    sim::TiledRaster& raster = group.map(kind).layers.front().raster;
    sim::Texel texel{value, value, value, value};
    texel[static_cast<std::size_t>(raster.channels()) - 1] = 65535;
    raster.setTexel(100, 100, texel);
}

/// A style with these groups, each changed in every part of a style.
inline model::Preset makePreset(const QString& name, const QStringList& groups, std::uint16_t value)
{
    model::Project project;
    for (const QString& group : groups) {
        project.groups.push_back(model::makeGroup(project, group, 256));
        model::HairGroup& made = project.groups.back();
        for (const model::MapKind kind :
             {model::MapKind::Density, model::MapKind::Length, model::MapKind::Colour, model::MapKind::Curl})
            paint(made, kind, value);
        made.settings.greatestLengthM = 0.6F;
        made.settings.greatestCurlRadiusM = 0.02F;
        made.settings.material.colourVariation = 0.5F;
    }
    return model::presetFrom(project, name);
}

inline model::Result<model::Preset> load(const QString& path)
{
    if (path == QStringLiteral("broken"))
        return model::failure(QStringLiteral("\"broken\" can't be read."));
    QStringList groups{QStringLiteral("Scalp")};
    if (path == QStringLiteral("bob"))
        groups.append(QStringLiteral("Ponytail")); // One of its own.
    if (path == QStringLiteral("look"))
        groups.append(QStringLiteral("Beard"));
    if (path == QStringLiteral("goatee"))
        groups = {QStringLiteral("Beard")};
    if (path == QStringLiteral("crest"))
        groups = {QStringLiteral("Crest")};
    return makePreset(path, groups, path == QStringLiteral("bob") ? 40000 : 60000);
}

/// Reads later on this thread, so that the strip never gets the answer within its own call.
inline void startLater(const QString& /*doing*/, const std::function<model::Result<model::Preset>()>& read,
                       QObject* receiver, const std::function<void(model::Result<model::Preset>)>& done)
{
    QMetaObject::invokeMethod(
        receiver, [read, done] { done(read()); }, Qt::QueuedConnection);
}

inline bool sameGroups(const std::vector<model::HairGroup>& a, const std::vector<model::HairGroup>& b)
{
    const auto sameLayer = [](const model::Layer& x, const model::Layer& y) {
        return x.id == y.id && model::propertiesOf(x) == model::propertiesOf(y) && x.raster == y.raster;
    };
    const auto sameMap = [&](const model::MapStack& x, const model::MapStack& y) {
        return x.kind == y.kind && x.size == y.size && std::ranges::equal(x.layers, y.layers, sameLayer);
    };
    return std::ranges::equal(a, b, [&](const model::HairGroup& x, const model::HairGroup& y) {
        return x.id == y.id && x.name == y.name && x.visible == y.visible && x.settings == y.settings &&
               std::ranges::equal(x.maps, y.maps, sameMap);
    });
}

struct StripFixture : PanelFixture
{
    StyleStrip strip{state, load, startLater};

    StripFixture()
    {
        std::vector<model::PresetEntry> entries;
        for (const char* name : {"bob", "waves", "broken", "look", "goatee", "crest"})
            entries.push_back({.path = QLatin1String(name),
                               .name = QLatin1String(name),
                               .tags = {},
                               .folder = QStringLiteral("built-in"),
                               .picture = {}});
        strip.setEntries(entries);
        // Away from the real pointer, which would point at a style too.
        QCursor::setPos(0, 0);
        strip.move(200, 200);
        strip.resize(800, 132);
        strip.show();
    }
    [[nodiscard]] const model::HairGroup& group(const char* name) const
    {
        return *std::ranges::find(document.project().groups, QString::fromLatin1(name), &model::HairGroup::name);
    }
    [[nodiscard]] QStringList groupNames() const
    {
        QStringList names;
        for (const model::HairGroup& one : document.project().groups)
            names.append(one.name);
        return names;
    }
    /// Paints on a group's map as a user's stroke does.
    void paintOn(model::Id id, model::MapKind kind, std::uint16_t value)
    {
        model::HairGroup changed = *document.committed().group(id);
        paint(changed, kind, value);
        const model::Layer& layer = changed.map(kind).layers.front();
        const int tile = layer.raster.tileCount() / 2;
        model::LayerTiles tiles;
        for (int index = 0; index <= tile; ++index)
            tiles.emplace_back(index, layer.raster.tile(index));
        document.push(paintCommand(document, {.group = id, .map = kind, .layer = layer.id}, std::move(tiles),
                                   QStringLiteral("Brush")));
    }
    [[nodiscard]] StyleQuestion& question() { return *strip.findChild<StyleQuestion*>(); }
    void click(int index, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseClick(&tile(index), Qt::LeftButton, modifiers);
        QCoreApplication::processEvents(); // It is read.
    }
    /// The first notch, with the pointer there.
    void turnWheel(int down, Qt::ScrollPhase phase = Qt::NoScrollPhase)
    {
        QWidget& viewport = *tile(0).parentWidget()->parentWidget();
        const QPoint at = viewport.mapFromGlobal(QCursor::pos());
        QWheelEvent event(at, QCursor::pos(), {}, QPoint(0, -down), Qt::NoButton, Qt::NoModifier, phase, false);
        QApplication::sendEvent(&viewport, &event);
    }
    [[nodiscard]] QTimer& pause() { return *strip.findChild<QTimer*>(QString(), Qt::FindDirectChildrenOnly); }
    [[nodiscard]] StyleTile& tile(int index) { return *strip.findChildren<StyleTile*>()[index]; }
    void enter(int index)
    {
        QEnterEvent event(QPointF(10, 10), QPointF(10, 10), QPointF(10, 10));
        QApplication::sendEvent(&tile(index), &event);
    }
    void leave(int index)
    {
        QEvent event(QEvent::Leave);
        QApplication::sendEvent(&tile(index), &event);
    }
};

} // namespace hairpaint::view
