// Tools, keys, selection, styles and help in the real window, driven by mouse and keys in both areas.
#include "model/document/layer_commands.h"
#include "tests/app/window_fixture.h"

#include "app/window/physical_keys.h"
#include "model/files/preset_file.h"
#include "model/styles/preset.h"
#include "tests/support/test_program.h"
#include "view/dialogs/help_dialog.h"
#include "view/dialogs/wind_dialog.h"
#include "view/paint_area/map_legend.h"
#include "view/panels/option_bar.h"
#include "view/panels/style_strip.h"
#include "view/panels/style_tile.h"
#include "view/panels/tool_bar.h"
#include "view/widgets/bar_slider.h"
#include "view/widgets/field_hint.h"
#include "view/widgets/value_palette.h"

#include <QDir>
#include <QLineEdit>
#include <QMessageBox>
#include <QToolButton>

namespace hairpaint::app {

class TestWindowTools : public QObject, private WindowFixture
{
    Q_OBJECT
private:
    [[nodiscard]] QWidget& paper() { return m_window->paintView(); }

    void click(QWidget& area, QPoint position, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseMove(&area, position);
        QTest::mousePress(&area, Qt::LeftButton, modifiers, position);
        QTest::mouseRelease(&area, Qt::LeftButton, modifiers, position);
    }

    /// Does `act` while closing the message box that it opens, and returns what that said.
    QString complaintOf(const std::function<void()>& act)
    {
        QString said;
        QTimer closer;
        connect(&closer, &QTimer::timeout, this, [&said] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                said += box->text() + QLatin1Char('\n');
                box->accept();
            }
        });
        closer.start(30);
        act();
        return said;
    }

private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void cleanup() { m_window.reset(); }

    void shiftClickDrawsAStraightLine()
    {
        openWindow(model::newProject());
        key(Qt::Key_9);
        key(Qt::Key_B);
        click(paper(), paintPoint(0.3F, 0.6F));
        QVERIFY(texelAt(0.3F, 0.6F)[1] > 0);
        QCOMPARE(int(texelAt(0.45F, 0.5F)[1]), 0);
        click(paper(), paintPoint(0.6F, 0.4F), Qt::ShiftModifier);
        QVERIFY(texelAt(0.45F, 0.5F)[1] > 0);
        QVERIFY(texelAt(0.6F, 0.4F)[1] > 0);
        QCOMPARE(stack().count(), 2);
        key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(int(texelAt(0.45F, 0.5F)[1]), 0);
    }

    void ctrlClickPicksInBothAreas()
    {
        openWindow(model::newProject());
        key(Qt::Key_9);
        key(Qt::Key_B);
        model::ToolSettings settings = editor().tools().settings();
        settings.value(model::MapKind::Gel).scalar = 0.75F;
        editor().tools().setSettings(settings);
        // Where the 3D area shows skin.
        view::HeadView& view = m_window->headView();
        const glm::vec2 seen = view.skinAt(QRectF(view.rect()).center()).value().uv;
        drag(paper(), paintPoint(seen.x - 0.03F, seen.y), paintPoint(seen.x + 0.03F, seen.y));
        const int steps = stack().count();
        for (const bool head : {false, true}) {
            settings = editor().tools().settings();
            settings.value(model::MapKind::Gel).scalar = 0.1F;
            editor().tools().setSettings(settings);
            const auto [area, position] =
                head ? onHead(seen.x, seen.y) : std::pair<QWidget*, QPoint>{&paper(), paintPoint(seen.x, seen.y)};
            click(*area, position, Qt::ControlModifier);
            const float picked = editor().tools().settings().value(model::MapKind::Gel).scalar;
            QVERIFY2(std::abs(picked - 0.75F) < 0.01F,
                     qPrintable(QStringLiteral("%1, %2").arg(picked).arg(QLatin1String(head ? "head" : "paper"))));
        }
        QCOMPARE(stack().count(), steps);
    }

    void aKeyFillsTheSelectionWithTheValue()
    {
        openWindow(model::newProject());
        key(Qt::Key_9);
        model::ToolSettings settings = editor().tools().settings();
        settings.value(model::MapKind::Gel).scalar = 0.75F;
        editor().tools().setSettings(settings);
        editor().tools().selection().setRectangle(QRectF(0.25, 0.25, 0.25, 0.25));
        key(Qt::Key_Backspace, Qt::AltModifier);
        QCOMPARE(stack().count(), 1);
        QVERIFY(std::abs(texelAt(0.3F, 0.3F)[0] - 0.75F * 65535.0F) < 2.0F);
        QCOMPARE(int(texelAt(0.3F, 0.3F)[1]), 65535);
        QCOMPARE(int(texelAt(0.6F, 0.3F)[1]), 0);
        // On a locked layer nothing is filled, and it is said why.
        const model::LayerAddress at = editor().target().address();
        model::Document& document = session().document();
        model::LayerProperties locked = model::propertiesOf(*document.committed().layer(at.group, at.map, at.layer));
        locked.locked = true;
        document.push(model::setLayerPropertiesCommand(document, at, locked, QStringLiteral("lock")));
        const QSignalSpy refused(&editor(), &view::EditorState::refused);
        settings.value(model::MapKind::Gel).scalar = 0.25F;
        editor().tools().setSettings(settings);
        key(Qt::Key_Backspace, Qt::AltModifier);
        QCOMPARE(stack().count(), 2);
        QCOMPARE(refused.count(), 1);
    }

    void keysAndDragsSetTheBrush()
    {
        openWindow(model::newProject());
        key(Qt::Key_B);
        const float size = editor().tools().settings().brushSizeM;
        key(Qt::Key_BracketRight);
        QVERIFY(editor().tools().settings().brushSizeM > size);
        key(Qt::Key_BracketLeft);
        QVERIFY(std::abs(editor().tools().settings().brushSizeM - size) < 1e-5F);
        const int steps = stack().count();
        for (const bool head : {false, true}) {
            const auto [area, position] =
                head ? onHead(0.5F, 0.5F) : std::pair<QWidget*, QPoint>{&paper(), paintPoint(0.5F, 0.5F)};
            const model::ToolSettings before = editor().tools().settings();
            QTest::mousePress(area, Qt::RightButton, Qt::ControlModifier, position);
            QTest::mouseMove(area, position + QPoint(40, 0));
            QTest::mouseRelease(area, Qt::RightButton, Qt::ControlModifier, position + QPoint(40, 0));
            QVERIFY(editor().tools().settings().brushSizeM > before.brushSizeM);
            QCOMPARE(editor().tools().settings().hardness, before.hardness);
            m_window->paintView().setFocus();
            QTest::keyPress(&paper(), Qt::Key_O);
            QTest::mousePress(area, Qt::LeftButton, {}, position);
            QTest::mouseMove(area, position - QPoint(60, 0));
            QTest::mouseRelease(area, Qt::LeftButton, {}, position - QPoint(60, 0));
            QTest::keyRelease(&paper(), Qt::Key_O);
            QVERIFY(editor().tools().settings().opacity < before.opacity);
        }
        QCOMPARE(stack().count(), steps);
    }

    void digitsChooseMapsAndXAndDTheValues()
    {
        openWindow(model::newProject());
        for (int digit = 1; digit <= std::min(model::kMapKindCount, kDigits); ++digit) {
            key(static_cast<Qt::Key>(Qt::Key_0 + digit % kDigits));
            QCOMPARE(editor().target().map(), static_cast<model::MapKind>(digit - 1));
        }
        const model::MapKind map = editor().target().map();
        model::ToolSettings settings = editor().tools().settings();
        settings.value(map).scalar = 0.3F;
        settings.secondValue(map).scalar = 0.9F;
        editor().tools().setSettings(settings);
        key(Qt::Key_X);
        QCOMPARE(editor().tools().settings().value(map).scalar, 0.9F);
        QCOMPARE(editor().tools().settings().secondValue(map).scalar, 0.3F);
        key(Qt::Key_D);
        QVERIFY(editor().tools().settings().value(map).scalar != 0.9F);
    }

    void selectionKeysSelectAndEverythingStaysInside()
    {
        openWindow(model::newProject());
        key(Qt::Key_9);
        const QRectF whole(0.0, 0.0, 1.0, 1.0);
        key(Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(editor().tools().selection().rectangle(), std::optional(whole));
        key(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(editor().tools().selection().rectangles().empty());
        key(Qt::Key_M);
        drag(paper(), paintPoint(0.3F, 0.6F), paintPoint(0.4F, 0.4F));
        QTest::mousePress(&paper(), Qt::LeftButton, Qt::ShiftModifier, paintPoint(0.6F, 0.6F));
        for (int i = 1; i <= 5; ++i) {
            const QPoint to = paintPoint(0.6F + 0.02F * static_cast<float>(i), 0.6F - 0.04F * static_cast<float>(i));
            QMouseEvent move(QEvent::MouseMove, to, paper().mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                             Qt::ShiftModifier);
            QCoreApplication::sendEvent(&paper(), &move);
        }
        QTest::mouseRelease(&paper(), Qt::LeftButton, Qt::ShiftModifier, paintPoint(0.7F, 0.4F));
        QCOMPARE(editor().tools().selection().rectangles().size(), std::size_t{2});
        key(Qt::Key_B);
        drag(paper(), paintPoint(0.25F, 0.5F), paintPoint(0.75F, 0.5F));
        QVERIFY(texelAt(0.35F, 0.5F)[1] > 0 && texelAt(0.65F, 0.5F)[1] > 0);
        QVERIFY(texelAt(0.28F, 0.5F)[1] == 0 && texelAt(0.5F, 0.5F)[1] == 0 && texelAt(0.73F, 0.5F)[1] == 0);
        key(Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
        drag(paper(), paintPoint(0.25F, 0.5F), paintPoint(0.75F, 0.5F));
        QVERIFY(texelAt(0.28F, 0.5F)[1] > 0 && texelAt(0.5F, 0.5F)[1] > 0 && texelAt(0.73F, 0.5F)[1] > 0);
        key(Qt::Key_Delete); // the inverse is still selected
        QVERIFY(texelAt(0.5F, 0.5F)[1] == 0 && texelAt(0.35F, 0.5F)[1] > 0);
        QCOMPARE(stack().undoText(), QStringLiteral("Clear Gel"));
        const auto layers = [this] {
            return session()
                .document()
                .committed()
                .group(editor().target().group())
                ->map(editor().target().map())
                .layers;
        };
        const std::size_t before = layers().size();
        key(Qt::Key_J, Qt::ControlModifier);
        QCOMPARE(layers().size(), before + 1);
        QVERIFY(layers().back().raster == layers()[before - 1].raster);
    }

    void copyingAndPastingWithinAMapIsOneStep()
    {
        openWindow(model::newProject());
        key(Qt::Key_9);
        key(Qt::Key_B);
        drag(paper(), paintPoint(0.32F, 0.5F), paintPoint(0.38F, 0.5F));
        key(Qt::Key_M);
        drag(paper(), paintPoint(0.3F, 0.55F), paintPoint(0.4F, 0.45F));
        key(Qt::Key_C, Qt::ControlModifier);
        drag(paper(), paintPoint(0.6F, 0.55F), paintPoint(0.7F, 0.45F));
        const QByteArray before = savedBytes("paste-before.hairpaint");
        QCOMPARE(int(texelAt(0.65F, 0.5F)[1]), 0);
        key(Qt::Key_V, Qt::ControlModifier);
        QVERIFY(texelAt(0.65F, 0.5F)[1] > 0);
        QCOMPARE(texelAt(0.65F, 0.5F)[0], texelAt(0.35F, 0.5F)[0]);
        QCOMPARE(stack().undoText(), QStringLiteral("Paste into Gel"));
        key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(savedBytes("paste-after.hairpaint") == before);
        // Cutting takes away what it copies.
        drag(paper(), paintPoint(0.3F, 0.55F), paintPoint(0.4F, 0.45F));
        key(Qt::Key_X, Qt::ControlModifier);
        QCOMPARE(int(texelAt(0.35F, 0.5F)[1]), 0);
        QCOMPARE(stack().undoText(), QStringLiteral("Cut Gel"));
    }

    void mirroredPaintingGoesToBothSides()
    {
        openWindow(model::newProject());
        key(Qt::Key_9);
        key(Qt::Key_B);
        QVERIFY(!editor().options().mirror());
        key(Qt::Key_L);
        QVERIFY(editor().options().mirror());
        drag(paper(), paintPoint(0.3F, 0.5F), paintPoint(0.4F, 0.55F));
        const model::LayerAddress at = editor().target().address();
        const sim::TiledRaster raster = session().document().committed().layer(at.group, at.map, at.layer)->raster;
        int painted = 0;
        for (int y = 0; y < raster.size(); y += 3)
            for (int x = 0; x < raster.size() / 2; x += 3) {
                painted += raster.texel(x, y)[1] > 0 ? 1 : 0;
                QCOMPARE(raster.texel(x, y), raster.texel(raster.size() - 1 - x, y));
            }
        QVERIFY(painted > 100);
        QCOMPARE(stack().count(), 1);
    }

    void cuttingWhileAPolygonIsOpenCutsWhatItPainted()
    {
        openWindow(model::newProject());
        editor().target().setMap(model::MapKind::Gel);
        editor().tools().choose(model::ToolId::Shape);
        model::ToolSettings settings = editor().tools().settings();
        settings.shape = model::ShapeKind::Polygon;
        editor().tools().setSettings(settings);
        for (const auto& [u, v] : {std::pair(0.3F, 0.3F), std::pair(0.7F, 0.3F), std::pair(0.5F, 0.7F)})
            QTest::mouseClick(&m_window->paintView(), Qt::LeftButton, {}, paintPoint(u, v));
        QVERIFY(editor().tools().stroking());
        editor().tools().selection().setRectangle(QRectF(0.4, 0.0, 0.2, 1.0));
        key(Qt::Key_X, Qt::ControlModifier);
        QVERIFY(!editor().tools().stroking());
        QCOMPARE(stack().count(), 2);
        QCOMPARE(int(texelAt(0.5F, 0.4F)[1]), 0); // Cut.
        QCOMPARE(int(texelAt(0.35F, 0.32F)[1]), 65535);
        key(Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(int(texelAt(0.5F, 0.4F)[1]), 65535);
    }

    void pointingAtAStylePreviewsItAndClickingKeepsIt()
    {
        openWindow(model::newProject());
        const QByteArray before = savedBytes("hover-before.hairpaint");
        auto* strip = m_window->findChild<view::StyleStrip*>();
        const QList<view::StyleTile*> tiles = strip->findChildren<view::StyleTile*>();
        QVERIFY(tiles.size() >= 9);
        view::StyleTile* bob = tiles.at(2);
        Q_EMIT bob->entered();
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 10'000, kPatienceMs);
        const std::size_t previewed = hairs();
        QVERIFY(session().document().previewing());
        QVERIFY(savedBytes("hover-shown.hairpaint") == before);
        Q_EMIT bob->left();
        QTRY_COMPARE_WITH_TIMEOUT(hairs(), std::size_t{0}, kPatienceMs);
        QCOMPARE(stack().count(), 0);
        QTest::mouseClick(bob, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(hairs(), previewed, kPatienceMs);
        QCOMPARE(stack().count(), 1);
        key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(savedBytes("hover-undone.hairpaint") == before);
    }

    void aStyleWithoutAPictureGetsOne()
    {
        const QString folder = ownPresetFolder();
        QVERIFY(QDir().mkpath(folder));
        const QString path = folder + QStringLiteral("/plain.hairpreset");
        model::Preset preset = *model::loadPreset(model::listPresets({}).back().path);
        preset.name = QStringLiteral("Plain");
        preset.picture = {};
        QVERIFY(model::savePreset(preset, path));
        openWindow(model::newProject());
        const auto tile = [this, &path]() -> view::StyleTile* {
            for (view::StyleTile* one : m_window->findChildren<view::StyleTile*>())
                if (one->path() == path)
                    return one;
            return nullptr;
        };
        QTRY_VERIFY_WITH_TIMEOUT(tile() != nullptr && tile()->hasPicture(), kPatienceMs);
        const model::Result<model::Preset> kept = model::loadPreset(path);
        QVERIFY(kept && kept->name == preset.name);
        QVERIFY(kept->picture.isNull()); // The user's file stays as it is.
        QFile::remove(path);
    }

    void aBrokenFileOfAnyKindIsOneMessageAndNoChange_data()
    {
        QTest::addColumn<QString>("ending");
        for (const char* ending : {"hairpaint", "hairpreset", "png", "jpg", "exr", "obj", "glb", "fbx"})
            QTest::newRow(ending) << QString::fromLatin1(ending);
    }
    void aBrokenFileOfAnyKindIsOneMessageAndNoChange()
    {
        QFETCH(QString, ending);
        openWindow(model::newProject());
        const QByteArray before = savedBytes("kept.hairpaint");
        const QString name = QStringLiteral("broken.") + ending;
        for (const bool exists : {true, false}) {
            const QString path = m_folder.filePath(name);
            QFile file(path);
            if (exists) {
                QVERIFY(file.open(QIODevice::WriteOnly));
                file.write("PK\x03\x04 nothing that any reader knows");
                file.close();
            } else {
                QFile::remove(path);
            }
            const QString said = complaintOf([&] { m_window->openFile(path); });
            QCOMPARE(said.count(QLatin1Char('\n')), 1);
            QVERIFY2(said.contains(name), qPrintable(said));
            QVERIFY(savedBytes("kept-after.hairpaint") == before);
            QCOMPARE(stack().count(), 0);
            QVERIFY(!session().document().modified());
        }
    }

    void altAndADigitShowThatMapOnTheHairWhileHeld()
    {
        openWholeWindow(starterProject());
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 10'000, kPatienceMs);
        const QByteArray before = savedBytes("look-before.hairpaint");
        const auto rootColour = [this] {
            const sim::Groom& groom = *session().frame()->groups.front().groom;
            for (const auto& chunk : groom.chunks)
                if (chunk != nullptr)
                    for (std::size_t slot = 0; slot < chunk->styles.size(); ++slot)
                        if (chunk->drawn[slot])
                            return chunk->styles[slot].rootColour;
            return std::uint32_t{0};
        };
        const std::uint32_t own = rootColour();
        auto* legend = m_window->headView().findChild<view::MapLegend*>();
        QVERIFY(legend != nullptr && !legend->isVisible());
        m_window->paintView().setFocus();
        QTest::keyPress(&paper(), Qt::Key_2, Qt::AltModifier);
        QVERIFY(legend->isVisible());
        QCOMPARE(legend->title(), QStringLiteral("Length, cm"));
        // From white to blue: the blue is full, red and green fall together.
        const auto isBlue = [&rootColour] {
            const std::uint32_t colour = rootColour();
            return (colour >> 16U & 0xFFU) == 0xFFU && (colour & 0xFFU) == (colour >> 8U & 0xFFU);
        };
        QTRY_VERIFY_WITH_TIMEOUT(isBlue(), kPatienceMs);
        QTest::keyRelease(&paper(), Qt::Key_2, Qt::AltModifier);
        QVERIFY(!legend->isVisible());
        QTRY_COMPARE_WITH_TIMEOUT(rootColour(), own, kPatienceMs);
        QVERIFY(savedBytes("look-after.hairpaint") == before);
        QCOMPARE(stack().count(), 0);
    }

    void aValueTypedAfterADoubleClickIsWhatIsPainted()
    {
        openWindow(model::newProject());
        key(Qt::Key_2);
        key(Qt::Key_B);
        const auto named = [](const QWidget& parent, const QString& label) {
            const auto all = parent.findChildren<view::BarSlider*>();
            return *std::ranges::find(all, label, [](const view::BarSlider* one) { return one->label(); });
        };
        view::BarSlider* bar = named(*m_window->findChild<view::OptionBar*>(), QStringLiteral("Length"));
        // As a mouse does it: press, release, press that makes it a double click, release.
        const auto openField = [&]() -> QLineEdit* {
            QTest::mouseDClick(m_window->windowHandle(), Qt::LeftButton, {},
                               bar->mapTo(m_window.get(), QPoint(bar->width() * 9 / 10, bar->height() / 2)));
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            return bar->findChild<QLineEdit*>();
        };
        const model::ToolSettings before = editor().tools().settings();
        const QString shown = bar->valueText();
        QLineEdit* field = openField();
        QVERIFY(field != nullptr);
        QVERIFY(editor().tools().settings() == before);
        QTest::keyClicks(field, QStringLiteral("long"));
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(field->isVisible());
        QVERIFY(!view::FieldHint::textAt(*bar).isEmpty());
        QTest::keyClick(field, Qt::Key_Escape);
        QVERIFY(editor().tools().settings() == before);
        QCOMPARE(bar->valueText(), shown);
        field = openField();
        QVERIFY(field != nullptr);
        QTest::keyClicks(field, QStringLiteral("1in + 4mm"));
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(bar->value(), 2.9);
        auto* palette = view::ValuePalette::openUnder(*bar, editor());
        QCOMPARE(named(*palette, QStringLiteral("Value"))->value(), 2.9);
        palette->window()->close();
        drag(paper(), paintPoint(0.4F, 0.5F), paintPoint(0.6F, 0.5F));
        const double painted = model::mapSpec(model::MapKind::Length)
                                   .scale->amount(editor().target().settings(), texelAt(0.5F, 0.5F)[0] / 65535.0);
        QVERIFY2(std::abs(painted - 0.029) < 1e-4, qPrintable(QString::number(painted)));
        QCOMPARE(stack().count(), 1);
    }

    void aReboundKeyIsToldInTheToolBarAndTheOpenHelp()
    {
        openWindow(model::newProject());
        key(Qt::Key_F1, Qt::ShiftModifier);
        auto* help = m_window->findChild<view::HelpDialog*>();
        QAction* gradient = m_window->actions().find(QLatin1StringView("tool.gradient"));
        const auto button = [this, gradient]() -> QString {
            for (const QToolButton* one : m_window->findChild<view::ToolBar*>()->findChildren<QToolButton*>())
                if (one->accessibleName() == gradient->iconText())
                    return one->toolTip().section(QStringLiteral("<b>"), 1).section(QStringLiteral("</b>"), 0, 0);
            return {};
        };
        const QString name = gradient->iconText();
        QCOMPARE(button(), name + QStringLiteral(" (G)"));
        QVERIFY(help->text().contains(name + QStringLiteral(" (G)")));
        gradient->setShortcut(QKeySequence(Qt::Key_F12));
        QCOMPARE(button(), name + QStringLiteral(" (F12)"));
        QTRY_VERIFY_WITH_TIMEOUT(help->text().contains(name + QStringLiteral(" (F12)")), kPatienceMs);
        QVERIFY(!help->text().contains(name + QStringLiteral(" (G)")));
        m_window->actions().find(QLatin1StringView("tool.larger"))->setShortcut(QKeySequence(Qt::Key_F11));
        QTRY_VERIFY_WITH_TIMEOUT(help->text().contains(QStringLiteral("[ and F11")), kPatienceMs);
        gradient->setShortcut({});
        QCOMPARE(button(), name);
        QTRY_VERIFY_WITH_TIMEOUT(!help->text().contains(name + QStringLiteral(" (")), kPatienceMs);
    }

    void helpTellsOfEveryToolAndKey()
    {
        openWindow(model::newProject());
        key(Qt::Key_F1, Qt::ShiftModifier);
        auto* help = m_window->findChild<view::HelpDialog*>();
        QVERIFY(help != nullptr && help->isVisible());
        const QString text = help->text();
        for (const auto& tool : editor().tools().all())
            QVERIFY2(text.contains(tool->title()) && text.contains(tool->hint()), tool->name());
        for (const view::KeyBinding& binding : m_window->actions().bindings())
            if (!binding.action->shortcut().isEmpty())
                QVERIFY2(text.contains(binding.action->shortcut().toString(QKeySequence::NativeText)),
                         qPrintable(binding.action->objectName()));
        help->close();
        QVERIFY(QTest::qWaitFor([this] { return m_window->findChild<view::HelpDialog*>() == nullptr; }));
        m_window->actions().find(QLatin1StringView("hair.windDialog"))->trigger();
        auto* wind = m_window->findChild<view::WindDialog*>();
        QVERIFY(wind != nullptr);
        QVERIFY(QTest::qWaitForWindowActive(wind));
        QTest::keyClick(wind, Qt::Key_F1);
        QVERIFY(wind->findChild<view::HelpDialog*>() != nullptr);
        wind->close();
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestWindowTools, Widgets)
#include "test_window_tools.moc"
